"""A plot of one curve for pgfplots and as a table: what is where, in which units."""

import math
import re

import pytest

from mechc.drawing.plots.from_plot import picture
from mechc.emit.pgfplots.to_pgfplots import to_pgfplots
from mechc.emit.picture import Picture, PlotPicture
from mechc.emit.plot_tables import head, to_csv, values
from mechc.plot.plot import Curve, FamilyValue, Mark, Panel, Plot, PlotAxis, PlotColumn
from mechc.pose.places import Plane
from mechc.report.languages.en.pictured import WORDS as EN
from mechc.units import ANGLE, LENGTH, NUMBER

PHI, K, A = PlotAxis("phi", ANGLE, "deg"), PlotAxis("k", NUMBER), PlotAxis("a", LENGTH, "mm")
LOW, HALF, HIGH = (math.radians(degrees) for degrees in (0, 30, 60))
RISE = (Plane(LOW, 1.0), Plane(HALF, 2.0))
FALL = (Plane(math.radians(40), 3.0), Plane(HIGH, 2.5))
SET = (FamilyValue(A, 0.05),)
COLUMNS = (
    PlotColumn(PHI, (), (LOW, HALF, HIGH)),
    PlotColumn(K, SET, (1.0, math.nan, math.inf)),
)


def plot(*curves, **more):
    return Plot("A plot", PHI, PHI, LOW, HIGH, (Panel(K, curves, 0.0, 4.0),), COLUMNS, **more)


def lines(*curves, **more):
    return to_pgfplots(plot(*curves, **more), EN).splitlines()


def plotted(found):
    return [line.split("coordinates ")[1] for line in found if line.startswith(r"\addplot")]


def test_each_piece_of_a_curve_is_a_plot_in_the_units_of_the_axes():
    found = lines(Curve("k", (), (RISE, FALL), poles=(math.radians(35),)))
    assert plotted(found) == ["{(0,1) (30,2)};", "{(40,3) (60,2.5)};"]
    (pole,) = (line for line in found if line.startswith(r"\draw[dash dot"))
    assert pole.startswith(r"\draw[dash dot, gray] (axis cs:35.0,")
    assert r"  xlabel={$\varphi ,\ ^{\circ}$}," in found
    assert r"  ylabel={$\mathit{k}$}," in found
    assert r"  ymin=0.0, ymax=4.0," in found
    assert any(line.startswith("  xtick={0,10,20,30,40,50,60}, ") for line in found)


def test_a_jump_is_a_thin_line_before_the_curve():
    jump = Curve("k", (), (RISE, FALL), jumps=(math.radians(35),))
    assert plotted(lines(jump))[0] == "{(30,2) (40,3)};"
    assert plotted(lines(jump))[1:] == ["{(0,1) (30,2)};", "{(40,3) (60,2.5)};"]


def test_marks_are_rings_and_the_default_pose_a_dot():
    marks = (Mark("minimum", Plane(LOW, 1.0)), Mark("default", Plane(HALF, 2.0)))
    found = [line for line in lines(Curve("k", (), (RISE,), marks)) if "circle" in line]
    assert [line.split(" (axis cs:")[1] for line in found] == [
        "0,1) circle[radius=0.9mm];",
        "30,2) circle[radius=0.9mm];",
    ]
    assert ["fill=white" in line for line in found] == [True, False]


def test_the_range_of_the_description_is_shaded():
    found = lines(Curve("k", (), (RISE,)), given=(LOW, HALF))
    (shade,) = (line for line in found if r"\fill[" in line)
    numbers = [float(number) for number in re.findall(r"[\d.]+(?=[,)])", shade)]
    assert numbers == pytest.approx([0, 0, 30, 4])


def test_a_table_has_names_settings_and_units_and_nothing_where_there_is_no_value():
    assert [head(column) for column in COLUMNS] == ["phi [deg]", "k (a = 50 mm)"]
    assert values(COLUMNS[0]) == [0.0, 30.0, 60.0]
    assert to_csv(plot(Curve("k", SET, (RISE,)))) == (
        "phi [deg],k (a = 50 mm)\n0.0,1.0\n30.0,\n60.0,inf\n"
    )


@pytest.mark.parametrize(
    ("suffix", "begin"),
    [(".svg", "<svg "), (".tex", "% A plot\n"), (".csv", "phi [deg],k (a = 50 mm)\n")],
)
def test_a_plot_is_written_as_its_suffix_says(tmp_path, suffix, begin):
    of = plot(Curve("k", SET, (RISE,)))
    PlotPicture(of, picture(of, EN), EN).save(tmp_path / f"plot{suffix}")
    assert (tmp_path / f"plot{suffix}").read_text("utf-8").startswith(begin)


def test_a_drawing_is_written_as_its_suffix_says(tmp_path):
    shown = Picture(picture(plot(Curve("k", SET, (RISE,))), EN))
    shown.save(tmp_path / "plot.svg")
    assert (tmp_path / "plot.svg").read_text("utf-8") == shown._repr_svg_()
    with pytest.raises(ValueError, match="none of the suffixes"):
        shown.save(tmp_path / "plot.csv")
