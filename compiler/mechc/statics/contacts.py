"""Contacts that would have to pull: two bodies that only touch can't."""

from collections.abc import Iterable, Iterator

from ..diagnostics import Diagnostic
from ..diagnostics.statics import contact_would_pull
from ..model.mechanism import LoadRatio
from ..model.result import Result
from .answers import pushes
from .unfold import Unfolding

PULL = 1e-9
"""A pull below this part of the load is rounding."""


def pulling(results: Iterable[Result], unfolding: Unfolding) -> Iterator[Diagnostic]:
    """Yield an error for each contact that pulls where the load below a ratio acts as drawn."""
    contacts = {t.point: t.span for t in unfolding.pose.touches if t.kind == "contact"}
    ratios = [r.target for r in results if isinstance(r.target, LoadRatio)]
    if not contacts or not ratios:
        return
    target = ratios[0]
    found = pushes(unfolding, target.above, target.below, "contact")
    for point, span in contacts.items():
        if found.get(point, 0.0) < -PULL:
            free = {n: unfolding.values[n] for n in unfolding.pose.free}
            yield contact_would_pull(span, point, target.below, found[point], free)
