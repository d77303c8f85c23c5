"""Laws: no order of lines, no names and no notation of a vector change a result.

Mechanisms with friction, their poses given or closed by a drive; every value that comes out
of one text must come out of the other, and the same remarks and statements with it.
"""

import math
import re
from collections.abc import Iterator, Mapping
from random import Random

import pytest

from force_samples import Compiled, compiled, samples
from friction_lines import friction_of, points
from grown import Grown
from mechc.diagnostics import MechcError
from mechc.formula.to_text import text as written
from mechc.model.result import Result
from mechc.study.analysis import DeadCentre, Vanishing
from mechc.study.locking_intervals import LockingInterval

ENOUGH = 1e-7
"""What two results may differ by, as a part of the larger: they are rounded in other orders."""


NEAR = 1e-6
"""What the ends of stretches may differ by: they are narrowed down from other places."""

LONG = 20
"""Lines of a description."""


def given(seeds: range, groups: int) -> Iterator[tuple[int, str]]:
    """Yield random descriptions of given poses with friction in all joints."""
    for seed, sample in samples(seeds, bool(seeds.start % 2), groups):
        asked = [f"find {a}" for a in sample.asked[:3]]
        yield seed, sample.with_friction(Random(seed), *asked, said=False)


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
    """Return the compilation of a text, or the codes of its errors."""
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
    others = {new.get(name, name): value for name, value in loads.items()}
    found, again = one.results(one.values() | loads), two.results(two.values() | others)
    if not label.startswith("components"):
        assert_same_statements(one, two, new, f"{label}\n{text}")
    if label.startswith("order"):
        assert in_one_order(conditions(one), conditions(two)), f"{label}\n{text}"
    for name, value in found.items():
        if "_direction" not in name:
            assert same(value, again[renamed(name, new)]), f"{label}, {name}\n{text}"
    return bool(found)


# -------------------------------------------------------------------------- statements


def conditions(made: Compiled) -> dict[str, list[str]]:
    """Return the conditions under which each result holds, as they are printed."""
    return {
        r.name: [f"{written(h.left)} {h.operator} {written(h.right)}" for h in r.holds]
        for r in made.compilation.results
    }


def in_one_order(one: dict[str, list[str]], two: dict[str, list[str]]) -> bool:
    """Tell whether the same conditions stand in the same order.

    A body that loops turn has its angle by the first of its vectors, so that the same may be
    stated by the angle of another one.
    """
    alike = [(one[n], two[n]) for n in one.keys() & two.keys() if {*one[n]} == {*two[n]}]
    return all(a == b for a, b in alike)


def assert_same_statements(one: Compiled, two: Compiled, new: dict[str, str], label: str) -> None:
    """Compare all that is said of each result."""
    again = {result.name: result for result in two.compilation.results}
    for result in one.compilation.results:
        other = again[renamed(result.name, new)]
        where = f"{result.name}, {label}"
        assert kinds(result) == kinds(other), where
        assert called(result.trends or {}, new) == dict(other.trends or {}), where
        assert called(result.proportional or {}, new) == dict(other.proportional or {}), where
        assert {new.get(n, n) for n in result.independent} == {*other.independent}, where
        swaps = {frozenset(new.get(n, n) for n in pair) for pair in result.swaps}
        assert swaps == {frozenset(pair) for pair in other.swaps}, where
        assert_same_friction(result, other, new, where)


def kinds(result: Result) -> list[tuple[str, str]]:
    """Return the kinds of zeros and poles, and how many there are of each."""
    of = (("zero", result.zeros), ("pole", result.poles))
    return sorted((side, kind(limit)) for side, limits in of for limit in limits)


def kind(limit: Vanishing) -> str:
    """Return why a ratio is zero or infinite, without the names of what stands still or moves."""
    return "dead centre" if isinstance(limit.cause, DeadCentre) else limit.cause


def called(items: Mapping[str, object], new: dict[str, str]) -> dict[str, object]:
    """Return the trends of each parameter, by its other name."""
    return {new.get(name, name): said for name, said in items.items()}


def assert_same_friction(one: Result, two: Result, new: dict[str, str], where: str) -> None:
    """Compare where a result is locked or jammed, and what an efficiency runs through."""
    assert (one.locking is None) == (two.locking is None), where
    if one.locking and two.locking:
        assert one.locking.state == two.locking.state, where
        reaches = {r.parameter: r.stretches for r in two.locking.reaches}
        assert {new.get(r.parameter, r.parameter) for r in one.locking.reaches} == {*reaches}
        for reach in one.locking.reaches:
            others = reaches[new.get(reach.parameter, reach.parameter)]
            assert [s.state for s in reach.stretches] == [s.state for s in others], where
            for first, second in zip(reach.stretches, others, strict=True):
                assert ends_of(first) == pytest.approx(ends_of(second), abs=NEAR), where
    efficiency_ranges = {c.parameter: c for c in two.efficiency_ranges}
    for efficiency in one.efficiency_ranges:
        other = efficiency_ranges[new.get(efficiency.parameter, efficiency.parameter)]
        figures = (efficiency.least, efficiency.greatest)
        assert figures == pytest.approx((other.least, other.greatest), abs=1e-3), where


def ends_of(stretch: LockingInterval) -> list[float]:
    """Return the ends of a stretch, where it has them."""
    return [end.x for end in (stretch.low, stretch.high) if end]


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


def renaming(text: str, dice: Random) -> dict[str, str]:
    """Return another name for each parameter."""
    found = re.findall(r"^param (\w+)", text, re.M)
    other = dice.sample(found, len(found))
    return dict(zip(found, other, strict=True))


def with_parameters(text: str, new: dict[str, str]) -> str:
    """Return a text with its parameters called otherwise; lines of friction have words as well."""
    return re.sub(r"(?<![\w.])[a-z]\w*", lambda m: new.get(m[0], m[0]), text)


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
        new = renaming(text, dice)
        compared += agree(one, with_parameters(text, new), new, f"parameters, seed {seed}")
        compared += agree(one, by_components(text, dice), {}, f"components, seed {seed}")
    return compared


def test_a_change_of_words_changes_nothing_of_closed_loops():
    assert hold(closed(range(6, 7))) >= 2


@pytest.mark.slow
@pytest.mark.parametrize("seed", [5, 11])
def test_a_change_of_words_changes_nothing_of_given_poses(seed):
    assert hold(given(range(seed, seed + 1), 1)) == 5


@pytest.mark.slow
def test_a_change_of_words_changes_nothing_of_many_closed_loops():
    assert hold(closed(range(8, 13))) >= 5


TOGGLE = """
param phi = atan2(-0.4, 2) in -40 deg .. 10 deg
pivot H at (-2.6 m, 1.9 m)
pivot N at (-1.4 m, -0.6 m)
link HE
link EP
link NP
HE = 2.04 m @ phi
EP = 2.48 m
NP = 3.15 m
assembly EPN cw
drive phi from -40 deg to 10 deg
torque M on HE
force F at P on NP along -y
friction pins 0.1 diameter 200 mm
find k = M/F
"""


def test_no_order_of_links_changes_the_order_of_conditions():
    swapped = TOGGLE.replace("link EP\nlink NP\n", "link NP\nlink EP\n")
    assert swapped != TOGGLE
    assert agree(outcome(TOGGLE), swapped, {}, "order of links")


ROD_TOGGLE = """
param al = 20 deg
pivot O
slider K along 90 deg
link OB
link BK
OB = 200 mm @ 90 deg + al
BK = 200 mm @ 90 deg - al
friction pins 0.1 diameter 20 mm
friction slider K 0.1
"""


def test_no_order_of_loads_says_which_one_follows():
    lines = ["force P at B along x", "force F at K along -y"]
    for text in ("\n".join([ROD_TOGGLE, *order, "find R_O"]) for order in (lines, lines[::-1])):
        assert outcome(text) == ["E595"]
        assert isinstance(outcome(f"{text}\nfind P"), Compiled)


def test_two_loads_of_which_each_follows_from_the_other_are_too_many_for_a_force():
    loads = "force P at B along x\nforce F at K along -y"
    for finds in ("find k = P/F\nfind j = F/P", "find j = F/P\nfind k = P/F"):
        assert outcome(f"{ROD_TOGGLE}{loads}\n{finds}\nfind R_O") == ["E595"]
        assert isinstance(outcome(f"{ROD_TOGGLE}{loads}\n{finds}"), Compiled)


def test_a_load_without_work_follows_from_nothing():
    """W presses the guide; P follows from F, wherever the lines stand."""
    lines = ["force W at K along x", "force P at B along x", "force F at K along -y", "let F = 5 N"]
    first, second = (outcome("\n".join([ROD_TOGGLE, *o, "find R_O"])) for o in (lines, lines[::-1]))
    assert isinstance(first, Compiled)
    assert isinstance(second, Compiled)
    sizes = {"W": 3.0, "F": 5.0}
    found, again = (made.results(made.values() | sizes) for made in (first, second))
    assert found["R_O_x_f"] == pytest.approx(again["R_O_x_f"], rel=1e-9)
