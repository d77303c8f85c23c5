"""What is drawn at the instantaneous centre of a link."""

import pytest

from mechc.drawing.moving import CROSS, Marks, draw_marks
from mechc.drawing.paper import on_paper
from mechc.drawing.pens import AXIS, SYMBOL
from mechc.drawing.sheet import Sheet
from mechc.figure.from_pose import draw
from mechc.figure.velocities import MotionVelocities
from mechc.pose.places import NOWHERE, Plane
from small_poses import VALUES, slider_crank

SPIN = 2.0


def drawn(centre):
    """Return the lines that mark the centre of the rod of a slider-crank, by their pens."""
    figure = draw(slider_crank(), VALUES)
    speeds = {p: figure.points[p].minus(centre).turned().times(SPIN) for p in "AB"}
    velocities = MotionVelocities("A", {"O": NOWHERE, **speeds}, {"OA": 0.0, "AB": SPIN}, ())
    sheet, paper = Sheet(), on_paper(figure)
    draw_marks(sheet, paper, Marks(centres=velocities, circles={"O": 0.01}))
    shapes = sheet.finished("", "").shapes
    return paper, {pen: [s.points for s in shapes if s.pen == pen] for pen in (AXIS, SYMBOL)}


def test_a_centre_is_a_cross_with_a_line_to_each_pin():
    centre = Plane(0.05, 0.06)
    paper, lines = drawn(centre)
    at = paper.place(centre)
    assert [line[0] for line in lines[AXIS]] == [paper.at("A"), paper.at("B")]
    arms = [end.minus(start) for start, end in lines[SYMBOL]]
    for arm, slope in zip(arms, (1, -1), strict=True):
        assert arm == pytest.approx((2 * CROSS, 2 * CROSS * slope))
    for start, end in lines[SYMBOL]:
        assert start.plus(end).times(0.5) == pytest.approx(at)


def test_a_centre_that_is_far_off_is_not_drawn():
    _, lines = drawn(Plane(10.0, 0.0))
    assert lines == {AXIS: [], SYMBOL: []}
