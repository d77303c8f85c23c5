"""How far what is drawn of the joints at a point reaches."""

import math

import pytest

from mechc.drawing.joints import reach
from mechc.drawing.paper import on_paper
from mechc.drawing.symbols import BLOCK, PIN
from mechc.figure.figure import Rack, Screw
from mechc.figure.from_pose import draw
from mechc.pose.places import Plane
from small_poses import RACK, SCREW, VALUES, driven_slider, slider_crank

X, Y = Plane(1.0, 0.0), Plane(0.0, 1.0)


def test_a_slider_reaches_along_its_guide_as_far_as_its_block():
    paper = on_paper(draw(slider_crank(), VALUES))
    assert reach(paper, "B", X) == BLOCK
    assert reach(paper, "B", Y) == PIN + 1
    assert reach(paper, "A", X) == 0


@pytest.mark.parametrize(("joint", "kind"), [(RACK, Rack), (SCREW, Screw)])
def test_a_rack_and_a_screw_reach_along_their_guide_as_far_as_they_are_long(joint, kind):
    paper = on_paper(draw(driven_slider(joint), VALUES))
    part = next(part for part in paper.figure.parts if isinstance(part, kind))
    ends = paper.ends(part.line if isinstance(part, Rack) else part.axis)
    assert reach(paper, "K", Y.times(-1)) == pytest.approx(math.dist(*ends) / 2) != BLOCK
    assert reach(paper, "K", X) == PIN + 1
