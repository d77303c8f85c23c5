"""Random mechanisms with friction in all joints, closed ones with a stroke and open ones."""

from random import Random

from force_mechanisms import given
from force_samples import pushing
from force_trains import train
from friction_lines import friction_of
from grown import Grown

WIDTHS = {"phi": ((0.25, 0.6, 1.5), "rad"), "s": ((0.01, 0.03), "m")}
"""Half the stroke; it may go beyond what the loop allows."""

TRIES = 1000
"""Seeds of grown mechanisms of which the first with one dyad is taken."""


def small_closed(seed: int) -> str:
    """Return a crank or cylinder and one dyad, with little friction: almost all of them move."""
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


STROKES = {"phi": ((0.25, 1.0, 2.6), "rad"), "s": ((0.04,), "m")}

SMALL = 2
"""Groups of a mechanism that does not take long."""


def closed(seed: int) -> str | None:
    """Return a closed mechanism with friction, its stroke beyond what the loops allow."""
    grown, dice = Grown(seed), Random(seed)
    if "triad" in grown.kinds or len(grown.kinds) > SMALL:
        return None
    widths, unit = STROKES[grown.drive]
    wide, text, start = dice.choice(widths), grown.text(), grown.start
    stroke = f"drive {grown.drive} from {start - wide!r} {unit} to {start + wide!r} {unit}"
    lines = [line for line in text.split("\n") if not line.startswith("drive ")]
    friction = friction_of(text, Random(seed), said=bool(seed % 2))
    return "\n".join([*lines, stroke, f"param q = {dice.choice((0.5, 1, 3))}", *friction])


def opened(seed: int) -> str | None:
    """Return a mechanism of a given pose, or a train, with friction in all joints."""
    dice = Random(seed)
    drawn = given(seed, dice.choice((1, 1, 2))) if seed % 3 else train(seed)
    sample = pushing(drawn)
    return sample and sample.with_friction(Random(seed), said=bool(seed % 2))
