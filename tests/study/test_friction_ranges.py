"""Friction over ranges, across dead centres: what is said of locking, jams and efficiencies.

Against free bodies with friction that is followed in from nothing, in mechanisms of two links
whose rod carries the load, so that the pressing forces are coupled, and in levers.
"""

import math
from random import Random

import pytest

from force_samples import Compiled, tree_of
from friction_chains import COUPLED, chain, made_of
from friction_statements import refuted
from good_mechanisms import begun
from mechc.model.parts.targets import LoadRatio
from mechc.study import sampling
from mechc.study.ratios import FrictionStudy
from mechc.study.sampling import sampled_values
from reference_balance import ratio
from reference_forces import Forces
from reference_geometry import defined

MOTIONS = {"k_f": 1, "k_hold": -1}


TOUCHING = """\
mechanism dz
param al = 20 deg in -40 deg .. 47 deg
param L = 100 mm
slider A along x
slider B along y
link AB
AB = L @ 90 deg + al
slider C along x
link BC
BC = L @ al
force P at A along -x
force F at C along -x
friction pins 0.1 diameter 4 mm
find k = P/F
"""


def result(made: Compiled, name: str):
    return next(r for r in made.compilation.results if r.name == name)


@pytest.mark.parametrize(
    ("al", "k_hold"), [(20.1, 56.51), (20.5, 45.45), (21, 36.503), (21.5, 30.493)]
)
def test_beside_a_dead_centre_of_the_drive_it_holds(al, k_hold):
    made = made_of(COUPLED)
    found = made.results({**made.values(), "al": math.radians(al)})
    assert found["k_hold"] == pytest.approx(k_hold, rel=2e-4)


def test_a_jam_is_no_locking():
    made = made_of(COUPLED)
    stuck = [s for n in MOTIONS for r in result(made, n).locking.reaches for s in r.stretches]
    assert [s.state for s in stuck] == ["jammed", "jammed"]


def test_locking_at_a_zero_that_is_only_touched():
    (reach, *_) = result(made_of(TOUCHING), "k_hold").locking.reaches
    (stuck,) = reach.stretches
    width = math.asin(2 * 0.0002 / 0.1)
    assert stuck.state == "locked"
    assert (stuck.low.x, stuck.high.x) == pytest.approx((-width, width), rel=1e-6)


def hold_to_free_bodies(seed: int, places: int) -> int:
    """Compare states and efficiencies at random places with free bodies; return how many."""
    text, dice = chain(seed), Random(seed + 1)
    made = made_of(text)
    study, compared = FrictionStudy(made.compilation.solution), 0
    for name, sense in MOTIONS.items():
        target = next(r.target for r in made.compilation.solution.results if r.name == name)
        for reach in result(made, name).locking.reaches:
            moving = study.moving(target.of, target.sense, reach.parameter)
            for _ in range(places):
                place = dice.uniform(*reach.range)
                values = defined(tree_of(text), {**made.values(), reach.parameter: place})
                there = ratio(Forces(tree_of(text), values), "P", "F", sense)
                ideal = moving.without(place)
                share = math.nan if there is None else there / ideal
                found = moving.at(place)
                where = f"seed {seed}: {name} at {reach.parameter} = {math.degrees(place)} deg"
                assert (found.state == "free") == (share > 0), where
                if share > 0:
                    assert found.share == pytest.approx(share, rel=1e-7), where
                stated = [s for s in reach.stretches if s.within and _is_in(place, *s.within)]
                assert bool(stated) == (not share > 0), where
                compared += 1
    return compared


def _is_in(place: float, low: float, high: float) -> bool:
    return low <= place <= high


def hold_to_sampling(seed: int) -> None:
    """Compare what an efficiency is said to run through with a dense sampling."""
    made = made_of(chain(seed))
    study, eta = FrictionStudy(made.compilation.solution), result(made, "eta_k")
    for efficiency in eta.efficiency_ranges:
        moving = study.moving(eta.target.of, eta.target.sense, efficiency.parameter)
        low, high = efficiency.range
        found = [moving.efficiency(low + (high - low) * (i + 0.5) / 400) for i in range(400)]
        found = [e for e in found if not math.isnan(e)]
        where = f"seed {seed}: {efficiency}"
        assert min(found) > efficiency.least - 1e-3, where
        assert max(found) < efficiency.greatest + 1e-3, where


def test_states_are_those_of_free_bodies():
    assert hold_to_free_bodies(3, 2) > 10


@pytest.mark.slow
def test_an_efficiency_runs_through_what_sampling_finds():
    hold_to_sampling(7)


@pytest.mark.slow
def test_many_states_are_those_of_free_bodies():
    assert sum(hold_to_free_bodies(seed, 3) for seed in range(20, 23)) > 45


FAR_OFF = """\
mechanism s
param t = 29.02 deg in -0.98 deg .. 59.02 deg
slider A along 269.8 deg
slider B along 76.2 deg
link AB
AB = 140.3 mm @ t
force P at A along 195.1 deg
force F at B along 142.5 deg
friction pins 0.122 diameter 21.2 mm
friction slider A 0.473
friction slider B 0.473
find k = P/F
"""
"""Forces that grow without end before all of the friction is there: no load balances."""


@pytest.mark.slow
def test_what_sticks_is_stated_where_it_takes_many_corrections():
    made = made_of(FAR_OFF)
    for degrees, state in ((-0.85, "locked"), (36.8, "jammed"), (54.2, "jammed")):
        place = math.radians(degrees)
        values = defined(tree_of(FAR_OFF), {**made.values(), "t": place})
        assert ratio(Forces(tree_of(FAR_OFF), values), "P", "F", 1) is None
        (reach,) = result(made, "k_f").locking.reaches
        states = [s.state for s in reach.stretches if s.within and _is_in(place, *s.within)]
        assert states == [state], degrees


ROPED = """
param th = 48 deg in 10 deg .. 106 deg
pivot O
pivot Q
link OAD
OA = 114 mm @ th
OD = 79 mm @ th - 15 deg
slider H along -y
rope A, Q along 140 deg, H along -y
force P at H along -y
force F at D along 5 deg
friction rope Q 0.16 wrap 130 deg
friction pin O 0.3 diameter 9 mm
friction slider H 0.08
find k = F/P
"""


def test_beside_a_pole_what_sticks_is_stated_where_iteration_gives_up():
    """Nearest to the pole at 20 degrees no friction is found; a little farther it jams."""
    made = made_of(ROPED)
    stuck = [s for r in result(made, "k_f").locking.reaches for s in r.stretches]
    assert [s.state for s in stuck] == ["jammed"]
    assert list(refuted(made.compilation)) == []
    assert [efficiency.least for efficiency in result(made, "eta_k").efficiency_ranges] == [0]


def test_dead_centres_are_looked_for_once_for_both_ways_of_the_motion(monkeypatch):
    study = FrictionStudy(begun("karpenko_fig9_with_friction").solution)
    of = LoadRatio("P", "F")
    there, back = (study.moving(of, sense, "alpha") for sense in ("tightening", "releasing"))
    ends = (-0.5, 1.5)  # sin(alpha + beta) is zero at -7 deg between them
    assert sampled_values(there, *ends)
    monkeypatch.setattr(sampling, "_dead_centres", None)
    assert sampled_values(back, *ends)
    (centre,) = back.ideal_along.centres[ends]
    assert math.degrees(centre) == pytest.approx(-7)
