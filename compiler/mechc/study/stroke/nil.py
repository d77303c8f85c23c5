"""Where results are zero all over a part of the stroke: a loop folds, and what it leads rests."""

from collections.abc import Iterator, Sequence
from itertools import pairwise

from ..tolerances import BRANCH_POINT
from .rounded import is_nil
from .run import Run
from .stroke import Branch, Extremum, Singular, StrokeInterval, ZeroInterval


def zero_parts(
    run: Run, stretches: Sequence[StrokeInterval], branches: Sequence[Branch]
) -> Iterator[ZeroInterval]:
    """Yield the parts between ends of stretches and branch points on which results are zero."""
    for stretch in stretches:
        inner = (b.drive for b in branches if stretch.low < b.drive < stretch.high)
        for low, high in pairwise((stretch.low, *sorted(inner), stretch.high)):
            if high - low > BRANCH_POINT * run.range:
                part = StrokeInterval(low, high, "", "")
                zero = (r.name for r in run.results if is_nil(r, run.along, part))
                yield from (ZeroInterval(name, low, high) for name in zero)


def is_apart(found: Singular | Extremum, nil: Sequence[ZeroInterval], range_: float) -> bool:
    """Return whether a singular pose or extremum is on no part on which its result is zero.

    At an end of one a result may jump.
    """
    near = BRANCH_POINT * range_
    if isinstance(found, Singular) and found.value == "undetermined":
        near = -near
    parts = (part for part in nil if part.result == found.result)
    return not any(p.low - near <= found.drive <= p.high + near for p in parts)
