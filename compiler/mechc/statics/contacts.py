"""Contacts that would have to pull: two bodies that only touch can't.

Each load that a result takes as given acts by itself, as directed: a contact is refused
that pulls under one of them and pushes under none.
"""

from collections.abc import Iterable, Iterator, Mapping

from ..diagnostics import Diagnostic
from ..diagnostics.statics import contact_would_pull
from ..model.mechanism import LoadForm, LoadRatio
from ..model.result import Result
from ..pose.pose import PointContact
from .answers import pushes
from .balanced import Balanced
from .poses import free_values
from .tolerances import PULL

Forces = Mapping[tuple[str, str], float]
"""What each body does to a pin, by pin and body; a pull is negative."""


def pulling(results: Iterable[Result], at: Balanced) -> Iterator[Diagnostic]:
    """Yield an error for each contact that pulls where the given loads act as drawn."""
    contacts = [t for t in at.pose.touches if t.kind == "contact"]
    refused: set[PointContact] = set()
    for result in results if contacts else ():
        forces = dict(_forces(result, at))
        for touch in contacts:
            found = {load: f.get((touch.point, touch.body), 0.0) for load, f in forces.items()}
            worst = min(found, key=lambda load: found[load], default="")
            if worst and found[worst] < -PULL and max(found.values()) < PULL:
                if touch not in refused:
                    yield _refused(touch, worst, found[worst], at)
                refused.add(touch)


def _forces(result: Result, at: Balanced) -> Iterator[tuple[str, Forces]]:
    """Yield what each load that a result takes as given does in the contacts."""
    mechanism = at.pose.mechanism
    given = {load.name for load in mechanism.loads if load.tie is not None}
    given |= {let.name for let in mechanism.lets}
    match result.target:
        case LoadRatio(above, below):
            yield below, pushes(at, above, below, given, "contact")
        case LoadForm(load):
            coefficients = result.coefficients or {}
            for other in coefficients:
                known = given | coefficients.keys()
                yield other, pushes(at, load, other, known, "contact")


def _refused(touch: PointContact, load: str, force: float, at: Balanced) -> Diagnostic:
    place = free_values(at.pose, at.values)
    return contact_would_pull(touch.span, touch.point, touch.body, load, force, place)
