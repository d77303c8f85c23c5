import math
from fractions import Fraction

import pytest

from by_hand import HERE, at, build, force, result, torque
from mechc.algebra.product import Product
from mechc.base.frozen import replace
from mechc.diagnostics import Report
from mechc.formula import tree as formula
from mechc.model import mechanism as model
from mechc.model.mechanism import LoadRatio
from mechc.pose.pose import Arm
from mechc.source import Source
from mechc.statics.geometry_check import worst_gap
from mechc.statics.referee import RefereeDisagrees, cross_check

POINTS = {"O": (0, 0), "A": (1, 2), "B": (4, 3), "C": (5, 0)}


def exact(value):
    return formula.number(Fraction(value))


def four_bar(*geometry, points=POINTS, **more):
    loads = [torque("M", "OA"), force("F", "B")]
    bodies = ["OA", "AB", "BC"]
    return build(
        points, bodies, "OC", more.pop("guides", {}), loads, {"F": 0}, geometry=geometry, **more
    )


def absolute(radians):
    return model.Absolute(exact(radians), HERE)


def gap(pose):
    found = worst_gap(pose, {})
    return (found.what, found.size) if found else None


def test_a_pose_that_fits_has_no_gap():
    entries = (
        model.Offset("O", "C", exact(5), exact(0), HERE),
        model.Arrow("O", "A", exact(math.sqrt(5)), absolute(math.atan2(2, 1)), HERE),
        model.Arrow("A", "B", None, absolute(math.atan2(1, 3)), HERE),
        model.Arrow("B", "C", exact(math.sqrt(10)), None, HERE),
        model.Arrow("C", "B", None, model.AlongLine("B", "C", 2, HERE), HERE),
        model.Turn("O", "A", "B", exact(math.atan2(1, 3) - math.atan2(-2, -1)), HERE),
    )
    assert gap(four_bar(*entries)) is None


@pytest.mark.parametrize(
    ("entry", "what", "size"),
    [
        (model.Offset("O", "C", exact(6), exact(0), HERE), "the loop through A and B", 1),
        (model.Arrow("O", "A", exact(3), None, HERE), "the vector OA", 3 - math.sqrt(5)),
        (model.Arrow("O", "C", None, absolute(0.1), HERE), "the vector OC", 5 * math.sin(0.1)),
        (model.Arrow("O", "B", None, model.AlongLine("O", "C", 1, HERE), HERE), "the vector OB", 4),
        (model.Turn("C", "O", "A", exact(1), HERE), "the angle COA", 2 * math.cos(1) - math.sin(1)),
    ],
    ids=["components", "length", "direction", "perpendicular", "turn"],
)
def test_a_pose_that_does_not_fit_names_what_is_off(entry, what, size):
    found = gap(four_bar(entry))
    assert found is not None
    assert found[0] == what
    assert found[1] == pytest.approx(abs(size))


def test_a_loop_of_links_that_stays_open_is_found():
    pose = four_bar(model.Offset("O", "C", exact(5), exact(0), HERE))
    bent = {**pose.frames, "AB": {**pose.frames["AB"], "B": pose.frames["OA"]["A"]}}
    pose = replace(pose, frames=bent)
    assert gap(pose) == ("the loop through A and B", pytest.approx(math.hypot(2, 1)))


def test_a_slider_stands_on_its_guide():
    points = {**POINTS, "C": (5, 1)}
    guide = model.Slider("C", absolute(0.0), HERE, through="O")
    pose = build(points, ["OA", "AB", "BC"], "O", {"C": 0}, [], {}, sliders=[guide])
    assert gap(pose) == ("the guide of C", pytest.approx(1))


def test_points_that_do_not_hang_together_are_not_measured():
    assert gap(build(POINTS, ["OA", "BC"], "OC", {}, [], {})) is None


def test_the_referee_stops_a_pose_that_does_not_fit():
    pose = four_bar(model.Offset("O", "C", exact(6), exact(0), HERE))
    report = Report(Source("four_bar.mech", "x"))
    with pytest.raises(RefereeDisagrees) as caught:
        cross_check(pose, (result("k", LoadRatio("M", "F"), 1),), report)
    assert "E603" in {d.code for d in caught.value.diagnostics}
    assert "the loop through A and B is off by 1 m" in str(caught.value)


def test_a_made_up_length_that_no_loop_fixes_is_not_measured():
    """A loop whose rods are given by their directions alone closes with lengths nobody knows."""
    pose = four_bar(model.Offset("O", "C", exact(5), exact(0), HERE))
    made_up = Product.symbol("len_AB")
    along = at(math.degrees(math.atan2(1, 3)))
    frames = {**pose.frames, "AB": {"A": (), "B": (Arm(made_up, along),)}}
    pose = replace(pose, frames=frames, placeholders={"len_AB": None})
    assert worst_gap(pose, {"len_AB": 1.7}) is None
    fixed = replace(pose, placeholders={"len_AB": made_up})
    assert worst_gap(fixed, {"len_AB": math.sqrt(10)}) is None
    assert worst_gap(fixed, {"len_AB": 1.7}).size == pytest.approx(math.sqrt(10) - 1.7)
