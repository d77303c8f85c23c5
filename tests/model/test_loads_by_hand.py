"""Where loads act, and in what unit their sizes are."""

import pytest

from by_hand import HERE, force, torque
from mechc.frozen import replace
from mechc.model.mechanism import ForcePair
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


def test_a_couple_alone_is_no_force():
    assert [k.dimension for k in (FORCE_ON_PIN, COUPLE, PAIR)] == [FORCE, TORQUE, FORCE]
