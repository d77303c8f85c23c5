"""Pictures in words: what is said of a plot, of a scheme, and what is left out."""

import math

import pytest

from mechc.base.frozen import replace
from mechc.drawing.describe import describe as say_scheme
from mechc.drawing.describe import say_velocities
from mechc.drawing.plots.describe_plot import describe, shown
from mechc.drawing.vectors import VelocityVectors
from mechc.figure.from_pose import draw
from mechc.figure.velocities import MotionVelocities
from mechc.plot.plot import Curve, FamilyValue, Mark, Panel, Plot, PlotAxis, Zone
from mechc.pose.places import Plane
from mechc.report.languages.en.pictured import WORDS as EN
from mechc.units import ANGLE, LENGTH, NUMBER
from small_poses import lever

PHI, K, A = PlotAxis("phi", ANGLE, "deg"), PlotAxis("k", NUMBER), PlotAxis("a", LENGTH, "mm")
HALF, END = math.radians(30), math.radians(60)
PIECE = (Plane(0.0, 2.0), Plane(END, 5.0))


def plot(curve, **more):
    return Plot("", PHI, PHI, 0.0, END, (Panel(K, (curve,), 0.0, 5.0),), (), **more)


def said(curve, **more):
    """Return the sentences that describe a plot of a curve."""
    return describe(plot(curve, **more), EN).removesuffix(".").split(". ")


def test_a_plot_says_its_axis_and_the_ends_of_its_curves():
    assert said(Curve("k", (), (PIECE,))) == [
        "k against phi from 0° to 60°",
        "k: 2 at the start, 5 at the end",
    ]


def test_a_curve_that_is_infinite_at_an_end_says_so():
    curve = Curve("k", (), (PIECE,), poles=(END,), dead_centres=(END,))
    assert said(curve)[1:] == [
        "k: 2 at the start, ∞ at the end",
        "k is infinite at phi = 60° (dead centre)",
    ]


def test_marks_poles_and_jumps_are_said_in_turn_and_stations_not():
    marks = (Mark("minimum", Plane(HALF, 1.25)), Mark("station", Plane(0.0, 0.0), HALF))
    curve = Curve("k", (FamilyValue(A, 0.05),), (PIECE,), marks, (HALF,), (END,))
    assert said(curve)[2:] == [
        "k, a = 50 mm has a minimum of 1.25 at phi = 30°",
        "k, a = 50 mm is infinite at phi = 30°",
        "k, a = 50 mm jumps at phi = 60°",
    ]


def test_a_path_has_no_ends_and_a_zone_says_what_holds_where():
    assert said(Curve("C", (), (PIECE,)), equal=True) == ["Path of C for phi from 0° to 60°"]
    zone = Zone(("k > 2", "k < 4"), ((0.0, HALF),))
    assert "k > 2 and k < 4 from 0° to 30°" in said(Curve("k", (), (PIECE,)), zone=zone)


@pytest.mark.parametrize(
    ("value", "axis", "text"),
    [(-0.5, PHI, "−28.65°"), (0.0125, A, "12.5 mm"), (1234.56, K, "1235")],
)
def test_values_are_shown_in_the_unit_of_their_axis(value, axis, text):
    assert shown(value, axis).replace("\xa0", " ") == text


# --------------------------------------------------------------------------- schemes


def test_a_scheme_says_its_parts_and_what_is_not_to_scale():
    figure = replace(draw(lever()), chosen=("len_OA", "b"), copies=3)
    assert say_scheme(figure, EN) == (
        "Kinematic scheme of by_hand. Links: OAB. Fixed pivots: O. Loads: P at A, F at B."
        " It is one of 3 equal branches. Not to scale: nothing gives OA, b."
    )


def test_velocities_are_said_with_their_directions_and_rests_are_not():
    found = MotionVelocities("", {"A": Plane(0.0, -2.0), "O": Plane(0.0, 0.0)}, {}, ())
    text = say_velocities(VelocityVectors(found), {"velocities": "velocities"})
    assert text.startswith("velocities: ")
    assert text.endswith("∠ 270°.")
    assert ";" not in text
