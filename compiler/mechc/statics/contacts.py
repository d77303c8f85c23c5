"""Contacts that would have to pull, ropes that would have to push: neither can.

Each load that a result takes as given acts by itself, as directed: a contact is refused
that pulls under one of them and pushes under none, a rope the other way round.
"""

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence

from ..diagnostics import Diagnostic
from ..diagnostics import statics as messages
from ..model.mechanism import Axial, LoadForm, LoadRatio, Normal, Reaction
from ..model.result import Result
from .answers import pushes
from .balanced import Balanced
from .poses import free_values
from .tolerances import NO_TENSION

ContactForces = Mapping[tuple[str, str], float]
"""What each body does to a pin, by pin and body; tension is negative. A rope's is its tension."""


def pulling(results: Sequence[Result], at: Balanced) -> Iterator[Diagnostic]:
    """Yield an error for each contact that pulls where the given loads act as drawn."""
    contacts = {(t.point, t.body): t for t in at.pose.contacts if t.kind == "contact"}
    for key, load, force in _wrong(results, at, contacts, "contact"):
        contact, place = contacts[key], free_values(at.pose, at.values)
        yield messages.contact_would_pull(
            contact.span, contact.point, contact.body, load, force, place
        )


def slack(results: Sequence[Result], at: Balanced) -> Iterator[Diagnostic]:
    """Yield an error for each rope that pushes where the given loads act as drawn."""
    ropes = {("", rope.id): rope for rope in at.pose.mechanism.ropes}
    for key, load, force in _wrong(results, at, ropes, "transfer"):
        rope, place = ropes[key], free_values(at.pose, at.values)
        yield messages.rope_would_push(rope.span, rope.id, load, force, place)


def _wrong(
    results: Iterable[Result], at: Balanced, joints: Collection[tuple[str, str]], kind: str
) -> Iterator[tuple[tuple[str, str], str, float]]:
    """Yield each joint whose force has the wrong sign, the load that asks for it, and its size."""
    refused: set[tuple[str, str]] = set()
    for result in results if joints else ():
        forces = dict(_forces(result, at, kind))
        for key in joints:
            found = {load: f.get(key, 0.0) for load, f in forces.items()}
            worst = min(found, key=lambda load: found[load], default="")
            if worst and found[worst] < -NO_TENSION and max(found.values()) < NO_TENSION:
                if key not in refused:
                    yield key, worst, found[worst]
                refused.add(key)


def _forces(result: Result, at: Balanced, kind: str) -> Iterator[tuple[str, ContactForces]]:
    """Yield the forces in the joints of one kind from each load that a result takes as given."""
    mechanism = at.pose.mechanism
    given = {load.name for load in mechanism.loads if load.tie is not None}
    given |= {let.name for let in mechanism.lets}
    match result.target:
        case LoadRatio(above, below):
            yield below, pushes(at, above, below, given, kind)
        case LoadForm(load):
            coefficients = result.coefficients or {}
            idle = [k.name for k in mechanism.loads if k.tie is None and k.name != load]
            others = dict.fromkeys((*coefficients, *idle))
            for other in others:
                known = given | others.keys()
                yield other, pushes(at, load, other, known, kind)
        case Axial() | Normal() | Reaction():
            # In a frame each load balances by itself; where something moves, not all of them do.
            loads = [load.name for load in mechanism.loads]
            found = {load: pushes(at, load, load, {*loads}, kind) for load in loads}
            yield from found.items() if all(found.values()) else ()
