"""Closed mechanisms of one group with little friction: almost all of them move."""

from random import Random

from friction_lines import friction_of
from grown import Grown

WIDTHS = {"phi": ((0.25, 0.6, 1.5), "rad"), "s": ((0.01, 0.03), "m")}
"""Half the stroke; it may go beyond what the loop allows."""

TRIES = 1000
"""Seeds of grown mechanisms of which the first with one dyad is taken."""


def small_closed(seed: int) -> str:
    """Return the description of a crank or cylinder and one dyad, all joints with friction."""
    grown = next(g for g in map(Grown, range(TRIES * seed, TRIES * (seed + 1))) if _is_small(g))
    dice = Random(seed)
    widths, unit = WIDTHS[grown.drive]
    wide, text = dice.choice(widths), grown.text()
    lines = [line for line in text.split("\n") if not line.startswith("drive ")]
    ends = [f"{grown.start + way * wide!r} {unit}" for way in (-1, 1)]
    lines.append(f"drive {grown.drive} from {ends[0]} to {ends[1]}")
    lines.append(f"param q = {dice.choice((0.05, 0.2, 0.5))}")
    return "\n".join([*lines, *friction_of(text, Random(seed), said=bool(seed % 2))])


def _is_small(grown: Grown) -> bool:
    """Return whether there is one group that moves; two guides on one line leave forces open."""
    return len(grown.kinds) == 1 and grown.kinds[0] not in ("triad", "rpp")
