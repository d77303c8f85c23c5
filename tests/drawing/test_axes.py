"""Axes on paper: where a value is, what stands at ticks, and the title."""

import pytest

from mechc.drawing.drawing import TextRun
from mechc.drawing.plots.axes import PanelFrame, heading, label, numbers_below, numbers_beside
from mechc.drawing.plots.ticks import Scale
from mechc.plot.plot import PlotAxis
from mechc.pose.places import Plane
from mechc.units import FORCE, LENGTH, NUMBER

FRAME = PanelFrame(Plane(10.0, 20.0), Plane(110.0, 70.0), Plane(0.0, -1.0), Plane(4.0, 1.0))
K, I, H = PlotAxis("k", NUMBER), PlotAxis("i", NUMBER), PlotAxis("h", LENGTH, "mm")  # noqa: E741


def written(runs):
    return "".join(run.text for run in runs)


@pytest.mark.parametrize(
    ("axes", "exponent", "title"),
    [
        ((K,), 0, "k"),
        ((K, I), 0, "k, i"),
        ((H,), 0, "h, mm"),
        ((K,), -3, "k, 10−3"),
        ((PlotAxis("P", FORCE, "kN"), PlotAxis("F", FORCE, "kN")), 2, "P, F, 102\u2009kN"),
    ],
)
def test_a_title_has_the_names_and_the_unit(axes, exponent, title):
    assert written(heading(axes, Scale((), 1.0, 0, exponent))) == title


def test_the_power_of_ten_is_raised():
    *_, exponent = heading((K,), Scale((), 1.0, 0, 4))
    assert (exponent.text, exponent.level) == ("4", 1)


def test_values_lie_between_the_corners_in_proportion():
    assert FRAME.at(Plane(0.0, -1.0)) == FRAME.low
    assert FRAME.at(Plane(4.0, 1.0)) == FRAME.high
    assert FRAME.at(Plane(1.0, 0.0)) == Plane(35.0, 45.0)
    assert FRAME.holds(Plane(35.0, 45.0))
    assert not FRAME.holds(Plane(35.0, 70.0))


def test_numbers_stand_below_and_beside_their_ticks():
    across, up = Scale((0.0, 2.0), 2.0, 0), Scale((-1.0, 1.0), 2.0, 1)
    below, beside = list(numbers_below(FRAME, across)), list(numbers_beside(FRAME, up))
    assert [(written(label.runs), label.at.x) for label in below] == [("0", 10.0), ("2", 60.0)]
    assert [(written(label.runs), label.at.y) for label in beside] == [
        ("−1.0", 20.0),
        ("1.0", 70.0),
    ]
    assert all(label.at.y + label.height / 2 < FRAME.low.y for label in below)
    assert all(label.at.x + label.width / 2 < FRAME.low.x for label in beside)


def test_a_label_begins_at_its_place_in_the_middle_of_its_height():
    found = label(Plane(10.0, 5.0), (TextRun("k_f"),))
    assert found.at.x - found.width / 2 == pytest.approx(10.0)
    assert found.at.y == 5.0
