"""Plots on paper: what stands behind the values beside marks."""

from mechc.drawing.drawing import Polyline
from mechc.drawing.from_plot import picture
from mechc.plot.plot import Axis, Curve, Mark, Panel, Plot
from mechc.pose.places import Plane
from mechc.report.languages.pictured import EN
from mechc.units import ANGLE, NUMBER

X, Y = Axis("alpha", ANGLE, "deg"), Axis("k", NUMBER)
ROOF = tuple(Plane(x / 10, 1.0 - abs(x / 10 - 0.5)) for x in range(11))


def test_a_value_beside_a_mark_stands_on_white_paper_that_is_larger_than_it():
    curve = Curve("k", (), (ROOF,), marks=(Mark("maximum", Plane(0.5, 1.0)),))
    plot = Plot("", X, X, 0.0, 1.0, (Panel(Y, (curve,), 0.0, 1.2),), ())
    drawing = picture(plot, EN)
    shapes = (s for s in drawing.shapes if isinstance(s, Polyline) and s.fill == "white")
    (paper,) = (shape.points for shape in shapes)
    low, high = paper[0], paper[2]
    (value,) = (k for k in drawing.labels if low.x < k.at.x < high.x and low.y < k.at.y < high.y)
    assert "".join(run.text for run in value.runs) == "(28.65°; 1)"
    assert high.x - low.x > value.width
    assert high.y - low.y > value.height
