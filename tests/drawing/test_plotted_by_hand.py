"""Plots on paper: what stands behind the values beside marks."""

import pytest

from mechc.drawing.drawing import Polyline
from mechc.drawing.plots.describe_plot import shown
from mechc.drawing.plots.from_plot import LEGEND_ROW, picture
from mechc.plot.plot import Curve, FamilyValue, Mark, Panel, Plot, PlotAxis
from mechc.pose.places import Plane
from mechc.report.languages.en.pictured import WORDS as EN
from mechc.units import ANGLE, FORCE, LENGTH, NUMBER

X, Y = PlotAxis("alpha", ANGLE, "deg"), PlotAxis("k", NUMBER)
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


def test_a_legend_has_a_sample_of_each_line_and_its_name_row_by_row_downwards():
    values = [FamilyValue(PlotAxis("a", LENGTH, "mm"), size) for size in (0.05, 0.07)]
    both = FamilyValue(PlotAxis("b", LENGTH, "mm"), 0.1)
    curves = tuple(Curve("k", (both, value), (ROOF,)) for value in values)
    drawing = picture(Plot("", X, X, 0.0, 1.0, (Panel(Y, curves, 0.0, 1.2),), ()), EN)
    written = {
        "".join(run.text for run in label.runs).replace("\u2009", " ").replace("\xa0", " "): label
        for label in drawing.labels
    }
    rows = [written[f"b = 100 mm, a = {size} mm"] for size in (50, 70)]
    heights = [row.at.y for row in rows]
    assert heights[0] - heights[1] == pytest.approx(LEGEND_ROW)
    samples = [s for s in drawing.shapes if isinstance(s, Polyline) and len(s.points) == 2]
    found = {p.y for s in samples for p in s.points if s.points[0].y == s.points[1].y}
    assert {*heights} <= found


def test_a_force_of_many_newtons_has_its_figures() -> None:
    """1.711e+04 N stood beside the mark."""
    axis = PlotAxis("R", FORCE, "N")
    assert shown(17110.2, axis) == "17110 N"
    assert shown(2.5e9, axis) == "2.5·10⁹ N"
    assert shown(2.5e-7, axis) == "2.5·10⁻⁷ N"
