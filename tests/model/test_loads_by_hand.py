"""Where loads act, and in what unit their sizes are."""

from fractions import Fraction

import pytest

from by_hand import HERE, build, force, torque
from mechc.base.frozen import replace
from mechc.formula.evaluate import evaluate
from mechc.formula.tree import number
from mechc.model.forces.resultants import with_points_of_resultants
from mechc.model.mechanism import Drawn, ForcePair, Spread
from mechc.units import FORCE, TORQUE

FORCE_ON_PIN = force("F", "B")
FORCE_ON_LINK = replace(FORCE_ON_PIN, link="OAB")
COUPLE = torque("M", "OAB")
PAIR = ForcePair("Q", "A", "C", HERE, first_link="OAB")


@pytest.mark.parametrize(
    ("load", "ends", "points", "links"),
    [
        (FORCE_ON_PIN, (("", "B"),), ("B",), ("",)),
        (FORCE_ON_LINK, (("OAB", "B"),), ("B",), ("OAB",)),
        (COUPLE, (), (), ("OAB",)),
        (PAIR, (("OAB", "A"), ("", "C")), ("A", "C"), ("OAB", "")),
    ],
)
def test_a_force_has_one_end_a_pair_two_and_a_couple_acts_on_its_link(load, ends, points, links):
    assert load.ends == ends
    assert load.points == points
    assert load.links == links


TWINS = replace(PAIR, joins_twins=True)


@pytest.mark.parametrize(
    ("load", "pushes", "host"),
    [
        (FORCE_ON_PIN, (("", "B", 1),), ""),
        (FORCE_ON_LINK, (("OAB", "B", 1),), "OAB"),
        (COUPLE, (), "OAB"),
        (PAIR, (("", "C", 1), ("OAB", "A", -1)), ""),
        (TWINS, (("OAB", "A", 1),), ""),
    ],
)
def test_a_pair_pushes_its_ends_apart_and_across_the_mirror_the_twin_has_the_other_force(
    load, pushes, host
):
    assert load.pushes == pushes
    assert load.host == host


@pytest.mark.parametrize(
    ("load", "kind", "name"),
    [
        (FORCE_ON_LINK, "load", "V_B"),
        (COUPLE, "spin", "omega_OAB"),
        (PAIR, "distance", "V_AC"),
    ],
)
def test_a_load_says_against_which_speed_it_works(load, kind, name):
    assert (load.against.kind, load.against.name) == (kind, name)


def test_a_couple_alone_is_no_force():
    assert [k.dimension for k in (FORCE_ON_PIN, COUPLE, PAIR)] == [FORCE, TORQUE, FORCE]


def test_a_spread_load_between_drawn_ends_acts_at_its_part_of_the_way():
    """A third of the way from (3, 2) to (9, -1) is (5, 1)."""
    places = {"A": (3, 2), "B": (9, -1)}
    drawn = tuple(Drawn(p, number(x), number(y), 0.0, "m", HERE) for p, (x, y) in places.items())
    spread = Spread("AB", "A", "B", number(1), number(Fraction(1, 3)))
    load = replace(force("Q", "M"), link="AB", spread=spread)
    beam = build(places, ["AB"], (), {}, [load], {}, drawn=drawn).mechanism
    (found,) = with_points_of_resultants(beam).drawn[2:]
    assert (found.point, evaluate(found.x, {}), evaluate(found.y, {})) == ("M", 5, 1)
