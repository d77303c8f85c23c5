"""Laws: no order of lines, no names and no notation of a vector change a result.

Mechanisms with friction, their poses given or closed by a drive; every value that comes out
of one text must come out of the other, and the same remarks with it.
"""

import math
import re
from collections.abc import Iterator
from random import Random

import pytest

from force_samples import Compiled, compiled, samples
from friction_lines import friction_of, points
from grown import Grown
from mechc.diagnostics import MechcError

ENOUGH = 1e-7
"""What two results may differ by, as a part of the larger: they are rounded in other orders."""


LONG = 20
"""Lines of a description."""


def given(seeds: range, groups: int) -> Iterator[tuple[int, str]]:
    """Yield random descriptions of given poses with friction in all joints."""
    for seed, sample in samples(seeds, bool(seeds.start % 2), groups):
        asked = [f"find {a}" for a in sample.asked[:1]]
        yield seed, sample.rubbing(Random(seed), *asked, said=False)


def closed(seeds: range) -> Iterator[tuple[int, str]]:
    """Yield random descriptions whose loops are closed, with friction in all joints.

    Long ones are left out: they take long, and have no other joints.
    """
    for seed in seeds:
        text = Grown(seed).text()
        if len(text.splitlines()) < LONG:
            friction = friction_of(text, Random(seed), said=False)
            yield seed, "\n".join([text, "param q = 1", *friction])


def outcome(text: str) -> Compiled | list[str]:
    """Return what a text compiles to, or the codes of its errors."""
    try:
        return compiled(text, "law.mech")
    except MechcError as error:
        return sorted({d.code for d in error.diagnostics if d.code[0] == "E"})


def remarks(made: Compiled) -> list[str]:
    """Return the codes of all remarks."""
    return sorted(d.code for d in made.compilation.report.diagnostics)


def same(first: float, second: float) -> bool:
    """Tell whether two results agree, as none agrees with none."""
    if math.isnan(first) or math.isnan(second):
        return math.isnan(first) == math.isnan(second)
    return abs(first - second) <= ENOUGH * max(abs(first), abs(second), 1e-6)


def agree(one: Compiled | list[str], text: str, new: dict[str, str], label: str) -> bool:
    """Compare what came out with what comes out of another text; tell whether anything did.

    ``new`` are the names that points have in the other text.
    """
    two = outcome(text)
    if isinstance(one, list) or isinstance(two, list):
        assert one == two, f"{label}\n{text}"
        return False
    assert remarks(one) == remarks(two), f"{label}\n{text}"
    loads = {k.name: 1.3 for k in one.compilation.mechanism.loads if k.tie is None}
    found, again = one.results(one.values() | loads), two.results(two.values() | loads)
    for name, value in found.items():
        if "_direction" not in name:
            assert same(value, again[renamed(name, new)]), f"{label}, {name}\n{text}"
    return bool(found)


# ----------------------------------------------------------------------------- changes


def shuffled(text: str, dice: Random) -> str:
    """Return the lines in another order."""
    lines = text.splitlines()
    dice.shuffle(lines)
    return "\n".join(lines)


def turned_round(text: str, dice: Random) -> str:
    """Return links with their points in another order."""
    lines = []
    for line in text.splitlines():
        word, *rest = line.split()
        if word == "link":
            letters = points(rest[0])
            dice.shuffle(letters)
            rest[0] = "".join(letters)
        lines.append(" ".join([word, *rest]))
    return "\n".join(lines)


def names_of(text: str) -> list[str]:
    """Return the points of a description."""
    lines = [line.split() for line in text.splitlines()]
    bodies = [w[1] for w in lines if w[0] in ("link", "slide", "pivot", "slider", "telescope")]
    return sorted({p for body in bodies for p in points(body)})


def relabelling(text: str, dice: Random) -> dict[str, str]:
    """Return a new name for each point."""
    found = names_of(text)
    new = found[:]
    dice.shuffle(new)
    return dict(zip(found, new, strict=True))


def renamed(text: str, new: dict[str, str]) -> str:
    """Return a text with its points called otherwise; loads are no points."""

    def called(match: re.Match[str]) -> str:
        parts = points(match[0])
        known = all(p in new for p in parts)
        return "".join(new[p] for p in parts) if known else match[0]

    return re.sub(r"(?<![A-Za-z0-9])[A-Z][A-Z0-9]*(?![A-Za-z0-9])", called, text)


def by_components(text: str, dice: Random) -> str:
    """Return a text in which vectors of a given length and direction are given by components."""
    vector = re.compile(r"^([A-Z]\w*) = (.+?) @ (.+)$", re.M)

    def other(match: re.Match[str]) -> str:
        name, length, angle = match.groups()
        if dice.random() < 0.3:
            return match[0]
        return f"{name} = (({length})*cos({angle}), ({length})*sin({angle}))"

    return vector.sub(other, text)


def hold(found: Iterator[tuple[int, str]]) -> int:
    """See that no change of the texts changes what comes out; return how many were compared."""
    compared = 0
    for seed, text in found:
        dice, one = Random(seed), outcome(text)
        new = relabelling(text, dice)
        compared += agree(one, shuffled(text, dice), {}, f"order of lines, seed {seed}")
        compared += agree(one, turned_round(text, dice), {}, f"letters of links, seed {seed}")
        compared += agree(one, renamed(text, new), new, f"names of points, seed {seed}")
        compared += agree(one, by_components(text, dice), {}, f"components, seed {seed}")
    return compared


def test_a_change_of_words_changes_nothing():
    assert hold(given(range(2, 4), 1)) >= 4


def test_a_change_of_words_changes_nothing_of_closed_loops():
    assert hold(closed(range(6, 8))) >= 4


@pytest.mark.slow
def test_a_change_of_words_changes_nothing_of_many():
    assert hold(given(range(11, 20), 1)) >= 16


@pytest.mark.slow
def test_a_change_of_words_changes_nothing_of_many_closed_loops():
    assert hold(closed(range(8, 30))) >= 24
