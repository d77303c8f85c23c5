"""How a mechanism hangs together, independent of names: the ranks of its points and bodies."""

from collections.abc import Sequence

import pytest

from mechc.compilation import Compilation
from mechc.formula.tree import ONE
from mechc.model.linkage.fast_pins import Adjacency, CarrierNode, FastPins, is_held, refined
from mechc.model.mechanism import WheelPair
from mechc.source import Source
from small_poses import HERE

PATH = [("point", name) for name in "abcde"]


def path(*labels: str) -> list[Adjacency]:
    return [(one, other, label) for one, other, label in zip(PATH, PATH[1:], labels, strict=False)]


def ranks(edges: Sequence[Adjacency], nodes: Sequence[CarrierNode] = PATH) -> list[int]:
    found = refined(dict.fromkeys(nodes, "pin"), edges)
    return [found[node] for node in nodes]


def test_what_lies_alike_has_one_rank() -> None:
    a, b, c, d, e = ranks(path("on", "on", "on", "on"))
    assert (a, b) == (e, d)
    assert len({a, b, c}) == 3
    assert ranks([]) == [0] * 5


def test_a_label_far_away_makes_a_difference() -> None:
    assert len({*ranks(path("on", "on", "on", "slot"))}) == 5
    assert refined({PATH[0]: "pin", PATH[1]: "pivot"}, []) == {PATH[0]: 0, PATH[1]: 1}


def test_the_order_of_edges_and_their_sense_make_none() -> None:
    edges = path("on", "slot", "on", "on")
    turned: list[Adjacency] = [(other, one, label) for one, other, label in reversed(edges)]
    assert ranks(turned) == ranks(edges)


def test_edges_to_what_is_not_there_do_not_count() -> None:
    assert ranks([*path("on", "on"), (PATH[0], ("body", "x"), "on")]) == ranks(path("on", "on"))


def carriers(text: str) -> FastPins:
    return FastPins(Compilation(Source("linkage.mech", text)).mechanism, {})


FOUR_BAR = """
mechanism bars
pivot O at (0 m, 0 m)
pivot C at (3 m, 0 m)
link OA
link AB
link CB
OA = {one} @ 60 deg
AB = 2 m
CB = {other}
assembly ABC cw
torque M on OA
torque T on CB
find k = M/T
"""


def test_a_pin_is_fast_in_a_link_at_a_pivot_before_the_coupler() -> None:
    found = carriers(FOUR_BAR.format(one="1 m", other="2 m"))
    assert [found.of(point) for point in "ABOC"] == ["OA", "CB", "", ""]


TONGS = """
mechanism tongs
pivot O at (0 m, 0 m)
link OA
link OB
link AC
link BC
OA = 1 m @ 60 deg
OB = 1 m @ 120 deg
AC = {right} @ {slope}
BC = {left} @ 30 deg
force P at C along -y
force F at A along x
force G at B along -x
find P
"""


def test_of_two_that_hang_alike_the_longer_one_is_first_whatever_its_name() -> None:
    assert carriers(TONGS.format(right="3 m", slope="150 deg", left="2 m")).of("C") == "AC"
    assert carriers(TONGS.format(right="2 m", slope="150 deg", left="3 m")).of("C") == "BC"


def test_of_two_as_long_the_first_by_its_direction() -> None:
    assert carriers(TONGS.format(right="2 m", slope="150 deg", left="2 m")).of("C") == "BC"
    assert carriers(TONGS.format(right="2 m", slope="10 deg", left="2 m")).of("C") == "AC"


@pytest.mark.parametrize(
    ("point", "link", "first"),
    [("C", "AC", "AC"), ("C", "BC", "BC"), ("A", "OA", "AC"), ("B", "OB", "BC")],
)
def test_of_two_as_long_a_load_on_a_link_decides_before_directions(point, link, first) -> None:
    """The pin is fast in the link that has the load, or is next to the one that has it."""
    text = TONGS.format(right="2 m", slope="150 deg", left="2 m")
    assert carriers(text + f"force R = 2*P at {point} on {link} along y\n").of("C") == first


def test_pivots_and_sliders_hold_their_pins() -> None:
    text = FOUR_BAR.format(one="1 m", other="2 m")
    mechanism = Compilation(Source("bars.mech", text)).mechanism
    assert [is_held(point, mechanism) for point in "OABC"] == [True, False, False, True]


@pytest.mark.parametrize(
    ("carried", "name"),
    [
        ({}, "gear A, B"),
        ({"arm": "AB", "first_link": "OC"}, "gear OC at A, the ground at B"),
        ({"arm": "AB", "second_link": "BD"}, "gear the ground at A, BD at B"),
    ],
)
def test_wheels_on_an_arm_differ_by_their_links(carried, name) -> None:
    """Two trains on one arm share their centres, so that these alone would name both."""
    own = {"first_link": "", "second_link": "", **carried}
    pair = WheelPair("gear", "A", own.pop("first_link"), ONE, "B", own.pop("second_link"), ONE,
                     same=False, span=HERE, **own)  # fmt: skip
    assert pair.id == name
