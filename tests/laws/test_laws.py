"""Laws that hold for every mechanism, on mechanisms grown at random."""

from random import Random

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

import mechc
from mechanisms import Style, sample
from mechc.compilation import Compilation
from mechc.formula.operations import count_operations
from mechc.formula.walk import symbols
from mechc.source import Source

SEEDS = st.integers(0, 10**6)

law = settings(max_examples=5, deadline=None, derandomize=True, database=None)


def solve(text):
    return mechc.loads(text, "law.mech")


def value(solved, name="k"):
    return float(solved.evaluate()[name])


def depends_on(solved, name, result="k"):
    found = solved.results[result]
    return name in symbols(found.formula).union(*(symbols(d.formula) for d in found.where))


@law
@given(SEEDS)
def test_turning_the_whole_drawing_leaves_k_alone(seed):
    drawn = sample(seed)
    turned = solve(drawn.linkage.text(Style(turn="turn")))
    assert not depends_on(turned, "turn")
    assert value(turned) == pytest.approx(drawn.k, rel=1e-7)


@law
@given(SEEDS)
def test_scaling_all_lengths_leaves_a_ratio_of_forces_alone(seed):
    drawn = sample(seed)
    scaled = solve(drawn.linkage.text(Style(scale="s")))
    of = {load.name: load.angle is None for load in drawn.linkage.loads}
    power = of["P"] - of["F"]
    assert depends_on(scaled, "s") == bool(power)
    assert value(scaled) == pytest.approx(drawn.k * 3**power, rel=1e-7)


@law
@given(SEEDS)
def test_the_names_of_points_do_not_matter(seed):
    drawn = sample(seed)
    once, again = (solve(x.text()) for x in (drawn.linkage, drawn.linkage.relabelled(seed)))
    assert value(once) == pytest.approx(value(again), rel=1e-9)
    assert length(once) == length(again)


@law
@given(SEEDS)
def test_the_order_of_statements_does_not_matter(seed):
    first, *rest, last = sample(seed).text.splitlines()
    once = solve("\n".join([first, *rest, last]))
    shuffled = [*rest, last]
    Random(seed).shuffle(shuffled)
    again = solve("\n".join([first, *shuffled]))
    assert value(once) == pytest.approx(value(again), rel=1e-9)
    assert length(once) == length(again)


def length(solved):
    return count_operations(solved.results["k"].formula)


@law
@given(SEEDS)
def test_from_drive_to_load_times_from_load_to_drive_is_one(seed):
    drawn = sample(seed)
    both = solve(drawn.linkage.text(Style(find="find k = P / F\nfind q = F / P")))
    assert value(both) * value(both, "q") == pytest.approx(1, rel=1e-9)


@law
@given(SEEDS)
def test_virtual_power_is_linear_in_the_loads(seed):
    """Two loads in one place add up, each with its k alone."""
    linkage = sample(seed).linkage.untied()
    assume(len(linkage.drivers) == 1 and linkage.solve() is not None)
    alone = value(solve(linkage.text()))
    both = solve(linkage.with_the_output_twice().text(Style(find="find P")))
    assert set(both.results["P"].coefficients) == {"F", "G"}
    assert float(both.evaluate(F=2.0, G=5.0)["P"]) == pytest.approx(7 * alone, rel=1e-9)


CLAW = """
param alpha = 20 deg in 5 deg .. 60 deg
slider A along x
slider B along y
link AB
AB = 100 mm @ 180 deg - alpha
force P at A along x
force F at B along y
friction pins 0.1 diameter 10 mm
friction slider B 0.1
find k = P/F
"""


def test_branches_of_two_halves_are_twice_as_many_branches():
    shared = ["copies 6 sharing A", "copies 3 sharing A\nmirror across x sharing A"]
    six, of_halves = (Compilation(Source("claw.mech", f"{CLAW}{line}\n")) for line in shared)
    assert of_halves.verdict.agrees
    values = [{r.name: r.default for r in one.results} for one in (six, of_halves)]
    assert values[0] == pytest.approx(values[1], rel=1e-12)
