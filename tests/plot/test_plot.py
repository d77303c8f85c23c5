"""Plots of mechanisms: values, marks, ranges, families, constraints, paths, and mistakes."""

import csv
import io
import math
import zipfile
from importlib import import_module
from importlib.util import find_spec

import numpy as np
import pytest

import mechc
from good_mechanisms import loaded
from mechc.base.frozen import replace
from mechc.cli import main
from mechc.compilation import Compilation
from mechc.diagnostics import MechcError
from mechc.drawing.plots.axes import GRID, PAPER, ZERO
from mechc.drawing.plots.panels import laid_out
from mechc.emit.svg.picture import to_svg
from mechc.plot.query import usual
from mechc.report.languages.en.pictured import WORDS as EN
from mechc.source import Source
from paths import EXAMPLES
from readable_drawings import assert_readable, lettering

CLAMP = "karpenko_fig9_packet_clamp"
CRANK = """mechanism crank
param phi = 60 deg
pivot O
slider B along 0 deg
link OA
link AB
OA = 100 mm @ phi
AB = @ -17 deg
torque M on OA
force F at B along 180 deg
find M/F
"""

SHORT_ROD = """mechanism short_rod
param phi = 5 deg
drive phi from -90 deg to 90 deg
pivot O
slider B along x through O
link OA
link AB
OA = 40 mm @ phi
AB = {rod}
assembly B forward
torque M on OA
force F at B along 180 deg
find M/F
"""

LEVERS = "karpenko_fig3_inclined_levers"


@pytest.fixture(scope="module")
def clamp():
    return mechc.load(CLAMP)


@pytest.fixture(scope="module")
def rocker():
    return loaded("crank_rocker")


def columns(plot):
    return [np.array(column.values) for column in plot.columns]


# -------------------------------------------------------------------------------- values


def test_k_over_the_range_of_the_description(clamp):
    found = clamp.plot("alpha").plot
    alpha, k = columns(found)
    assert alpha[[0, -1]] == pytest.approx(np.radians([2, 40]))
    assert k == pytest.approx(0.2 * (np.tan(alpha) + math.tan(math.radians(7))), rel=1e-13)
    (curve,) = found.curves
    (piece,) = curve.pieces
    for x, y in piece:
        assert y == pytest.approx(0.2 * (math.tan(x) + math.tan(math.radians(7))), rel=1e-13)
    ((kind, at, _),) = curve.marks
    assert kind == "default"
    assert at == pytest.approx((math.radians(12), clamp.evaluate()["k"]))


def test_a_family_beyond_the_range(clamp):
    found = clamp.plot("alpha", family={"beta": ["10 deg", 0.3]}, range=("0 deg", "180 deg")).plot
    assert found.given == pytest.approx(np.radians([2, 40]))
    for curve, beta in zip(found.curves, (math.radians(10), 0.3), strict=True):
        assert [v.value for v in curve.setting] == pytest.approx([beta])
        assert curve.poles == pytest.approx([math.pi / 2])
        assert [m.at.x for m in curve.marks] == pytest.approx([math.pi - beta])
        assert all(not (p[0].x < math.pi / 2 < p[-1].x) for p in curve.pieces)
    assert max(found.panels[0].high, -found.panels[0].low) < 5


def test_the_pose_of_the_description_is_marked_on_its_own_curve_alone(clamp):
    found = clamp.plot("alpha", family={"beta": ["7 deg", "8 deg"]}).plot
    assert [[m.kind for m in curve.marks] for curve in found.curves] == [["default"], []]
    picture = clamp.plot("alpha", family={"beta": ["8 deg"]})
    assert "default pose" not in picture.alt
    assert "at the default pose, alpha = 12°." in clamp.plot("alpha").alt
    assert {"β = 8°", "k"} <= set(lettering(picture.drawing))


@pytest.mark.parametrize(
    ("family", "values"),
    [("a=1,2e2,30mm", [0.001, 0.2, 0.03]), ("a=1e2,0.2m", [100, 0.2]), ("a=1 mm,2", None)],
)
def test_the_unit_of_the_last_value_is_that_of_all_without_one(family, values, tmp_path, capsys):
    line = ["plot", CLAMP, "--x", "alpha", "--family", family, "-n", "2"]
    status = main([*line, "-o", str(tmp_path / "k.csv")])
    if values is None:
        assert "2 what? Expected a length (mm)" in capsys.readouterr().err
        return
    assert status == 0
    with (tmp_path / "k.csv").open(encoding="utf-8") as file:
        _, (_, *found), _ = csv.reader(file)
    one = 0.2 * (math.tan(math.radians(2)) + math.tan(math.radians(7))) / 0.1
    assert [float(k) for k in found] == pytest.approx([one * a for a in values])


def test_a_family_of_what_is_along_the_axis_makes_no_sense(clamp):
    with pytest.raises(MechcError, match="E584: alpha is no parameter to vary"):
        clamp.plot("alpha", family={"alpha": ["3 deg"]})


def test_along_a_constraint_as_figure_5_of_karpenko():
    """A range of the parameter that follows is that of what it was before."""
    levers = mechc.load(LEVERS)
    ends = ("0 deg", "80 deg")
    found = levers.plot("alpha", "z", along={"theta": "80 deg - alpha"}, range=ends, points=9)
    alpha, z = columns(found.plot)
    whole = math.radians(80)
    expected = np.cos(alpha) * np.sin(whole - alpha) / math.cos(whole)
    assert z == pytest.approx(expected, rel=1e-12, abs=1e-12)
    assert z[[0, 4]] == pytest.approx([5.671281819617709, 2.8356409098088546], rel=1e-12)


def test_over_the_stroke_of_the_drive():
    found = loaded("claw_closed").plot(y=["k", "gamma", "beta"]).plot
    assert [[c.name for c in p.curves] for p in found.panels] == [["k"], ["gamma", "beta"]]
    assert (found.x.name, found.x.unit, found.low, found.high) == ("phi", "rad", 1.0, 2.0)
    least = next(m.at for m in found.curves[0].marks if m.kind == "minimum")
    assert least == pytest.approx((1.380557799745, 1.372773669854), abs=1e-9)
    most = next(m.at for m in found.curves[1].marks if m.kind == "maximum")
    assert most == pytest.approx((math.atan(5), math.pi / 2), abs=1e-7)


def test_with_friction_and_of_a_sheet():
    clamp = loaded("karpenko_fig9_with_friction")
    _, k, k_f = columns(clamp.plot("alpha", ["k", "k_f"]).plot)
    assert (k_f > k).all()
    found = mechc.load(EXAMPLES / "pin.mech").plot("F", "tau", range=("1 kN", "4 kN")).plot
    assert found.panels[0].y.unit == "MPa"
    assert found.curves[0].jumps  # the diameter taken is one of a list
    assert found.x.unit == "kN"


def test_velocities_and_accelerations_where_the_drive_has_a_speed():
    text = (
        "mechanism m\nparam phi = 0.3 rad\npivot O at (0 mm, 0 mm)\nlink OA\n"
        "OA = 100 mm @ phi\ndrive phi from 0 deg to 360 deg speed 2 rad/s\n"
        "force P at A along x\nforce F at A along y\nfind k = P/F\n"
    )
    phi, v, a = columns(mechc.loads(text).plot(y=["V_A_x", "a_A_x"]).plot)
    assert v == pytest.approx(-0.2 * np.sin(phi), abs=1e-12)
    assert a == pytest.approx(-0.4 * np.cos(phi), abs=1e-12)


@pytest.mark.parametrize(("rod", "marked"), [("10 mm", [0]), ("30 mm", [-45, -30, -15, 0, 15, 30])])
def test_a_path_is_marked_wherever_there_is_a_pose(rod, marked):
    """A rod of 10 mm follows a crank of 40 mm up to 14.5°: one of thirteen stations is left.

    With 30 mm the path comes back at 45° to where it was at -45°, which is marked already.
    """
    found = mechc.loads(SHORT_ROD.format(rod=rod)).plot(path="B").plot
    (curve,) = found.curves
    assert [math.degrees(m.station) for m in curve.marks] == pytest.approx(marked, abs=1e-9)


def test_the_path_of_a_point_keeps_its_shape(rocker):
    picture = rocker.plot(path="A")
    ((curve,),) = (panel.curves for panel in picture.plot.panels)
    ((*places,),) = curve.pieces
    radii = [math.hypot(*p) for p in places]
    assert radii == pytest.approx([0.04] * len(radii))
    assert len(curve.marks) == 12
    layout = laid_out(picture.plot, picture.plot.panels[0], EN)
    step = layout.frame.high.minus(layout.frame.low)
    span = layout.frame.most.minus(layout.frame.least)
    assert step.x / span.x == pytest.approx(step.y / span.y)


def test_the_zone_in_which_a_condition_holds():
    """Manzhosov and Samsonov: rational where gamma is at least 1.5 rad."""
    claw = loaded("claw_closed")
    picture = claw.plot(y="k", where="gamma >= 1.5 rad")
    assert picture.plot.zone.stretches == (pytest.approx((1.305764, 1.441927), abs=1e-6),)
    for place in picture.plot.zone.stretches[0]:
        assert claw.evaluate(phi=place)["gamma"] == pytest.approx(1.5, abs=1e-14)
    assert "gamma >= 1.5 rad from 1.306 rad to 1.442 rad." in picture.alt
    apart = claw.plot(y="k", where=["gamma <= 1.5 rad"]).plot.zone.stretches
    assert [end for stretch in apart for end in stretch] == pytest.approx(
        [1.0, *picture.plot.zone.stretches[0], 2.0]
    )


def test_what_nothing_depends_on_is_a_level_line(clamp):
    found = clamp.plot("d", "k", range=("10 mm", "20 mm")).plot
    assert len(set(columns(found)[1])) == 1


# ------------------------------------------------------------------------------ pictures

PLOTS = {
    "one": (CLAMP, {"x": "alpha"}),
    "family": (CLAMP, {"x": "alpha", "family": {"beta": [0.1, 0.3]}, "range": (0.0, 3.0)}),
    "panels": ("crank_rocker", {"y": ["k", "i", "mu_B"]}),
    "path": ("crank_rocker", {"path": ["A", "B"]}),
    "large": ("claw_closed", {"y": "k", "range": (0.05, 3.0)}),
}
every_plot = pytest.mark.parametrize("name", PLOTS)


def plotted(name):
    mechanism, asked = PLOTS[name]
    return mechc.load(mechanism).plot(**asked)


@every_plot
def test_labels_lie_on_no_curve_and_touch_none(name):
    drawing = plotted(name).drawing
    shaded = {"given", GRID.name, PAPER.name, ZERO.name}
    lines = tuple(shape for shape in drawing.shapes if shape.pen.name not in shaded)
    assert_readable(replace(drawing, shapes=lines))


@every_plot
def test_curves_stay_inside_their_panel(name):
    plot = plotted(name).plot
    for panel in plot.panels:
        layout = laid_out(plot, panel, EN)
        least, most = layout.frame.least, layout.frame.most
        assert least.y <= panel.low / panel.y.size + 1e-9
        assert panel.high / panel.y.size - 1e-9 <= most.y
        assert 2 <= len(layout.up.ticks) <= 10


def test_what_the_picture_says(clamp):
    picture = clamp.plot("alpha", family={"beta": ["10 deg"]}, range=("0 deg", "180 deg"))
    assert "k, beta = 10° is infinite at alpha = 90°." in picture.alt
    assert "k, beta = 10° is 0 at alpha = 170° (dead centre)." in picture.alt
    assert picture.alt in to_svg(picture.drawing).replace("&gt;", ">")
    assert {"0", "30", "180", "dead centre, 170°", "90°"} <= set(lettering(picture.drawing))


def test_latex_has_the_same_axes_and_values(clamp, tmp_path):
    picture = clamp.plot("alpha")
    picture.save(tmp_path / "k.tex")
    text = (tmp_path / "k.tex").read_text("utf-8")
    assert "xmin=2.0, xmax=40.0" in text
    assert "xtick={5,10,15,20,25,30,35,40}" in text
    for place in picture.plot.curves[0].pieces[0][:1]:
        assert f"({math.degrees(place.x):.8g},{place.y:.8g})" in text


# ----------------------------------------------------------------------- the command line


def test_every_format_is_written(tmp_path, capsys):
    suffixes = (".svg", ".tex", ".csv", *([".png"] if find_spec("typst") else []))
    paths = [tmp_path / f"k{suffix}" for suffix in suffixes]
    line = ["plot", CLAMP, "--x", "alpha", "--y", "k", "--family", "beta=10,20deg", "-n", "3"]
    assert main([*line, *(word for p in paths for word in ("-o", str(p)))]) == 0
    assert capsys.readouterr() == ("", "")
    assert all(path.stat().st_size for path in paths)
    rows = list(csv.reader(io.StringIO(paths[2].read_text("utf-8"))))
    assert rows[0] == ["alpha [deg]", "k (beta = 10 deg)", "k (beta = 20 deg)"]
    assert [row[0] for row in rows[1:]] == ["2.0", "21.0", "40.0"]
    assert main(line) == 0
    assert capsys.readouterr().out == paths[0].read_text("utf-8")


def test_a_sheet_of_excel_has_the_values(tmp_path, clamp):
    pytest.importorskip("xlsxwriter")
    for name in ("a.xlsx", "b.xlsx"):
        clamp.plot("alpha", points=3).save(tmp_path / name)
    assert (tmp_path / "a.xlsx").read_bytes() == (tmp_path / "b.xlsx").read_bytes()
    with zipfile.ZipFile(tmp_path / "a.xlsx") as book:
        sheet = book.read("xl/worksheets/sheet1.xml").decode()
    assert '<c r="A3"><v>21</v></c>' in sheet


def test_pdf_is_a_page(tmp_path, clamp):
    pytest.importorskip("typst")
    clamp.plot("alpha").save(tmp_path / "k.pdf")
    assert (tmp_path / "k.pdf").read_bytes().startswith(b"%PDF")


@pytest.mark.parametrize("suffix", ["pdf", "png", "xlsx"])
def test_a_library_that_is_missing(suffix, tmp_path, monkeypatch, capsys):
    """E721, as an exit status of the environment."""

    def missing(name):
        if name in ("typst", "xlsxwriter"):
            raise ImportError(f"no module {name}")
        return import_module(name)

    for module in ("mechc.emit.svg.picture", "mechc.emit.plot_tables"):
        monkeypatch.setattr(f"{module}.import_module", missing)
    target = tmp_path / f"k.{suffix}"
    assert main(["plot", CLAMP, "--x", "alpha", "-o", str(target)]) == 3
    assert f"pip install 'mechc[{suffix}]'" in capsys.readouterr().err
    assert not target.exists()


MISTAKES = {
    "E583": ([CLAMP, "--x", "alpha", "--y", "kk"], "kk cannot be plotted, expected k, delta or p"),
    "E584": ([CLAMP, "--x", "alhpa"], "did you mean 'alpha'?"),
    "E585": ([CLAMP, "--x", "a"], 'as in --range "10 mm .. 80 mm"'),
    "E586": ([CLAMP, "--x", "alpha", "--y", "p"], "p rests on F, expected a value"),
    "E587": ([CLAMP], "name it, as in --x alpha"),
    "E588": (["crank_rocker", "--x", "b", "--range", "1 mm..2 mm"], "k has no value for any b"),
    "E589": ([CLAMP, "--x", "alpha", "--family", f"beta={'1,' * 12}2deg"], "at most 12"),
    "E598": (
        ["claw_closed", "--family", "l=400,500mm", "--where", "gamma >= 1.5 rad"],
        "leave out the family",
    ),
    "E599": (["crank_rocker", "--path", "C"], "C has no path, expected O1, O2, A or B"),
}


@pytest.mark.parametrize("code", MISTAKES)
def test_mistakes_are_stated(code, capsys):
    line, said = MISTAKES[code]
    assert main(["plot", *line]) == 1
    out, err = capsys.readouterr()
    assert out == ""
    assert f"error[{code}]" in err
    assert said in err


@pytest.mark.parametrize(
    ("line", "said"),
    [
        (["--x", "alpha", "-o", "k.bmp"], "has none of the suffixes .svg"),
        (["--x", "alpha", "--family", "beta"], "is not NAME=VALUE,VALUE"),
        (["--x", "alpha", "--family", "beta=1,,2deg"], "is not NAME=VALUE,VALUE"),
        (["--x", "alpha", "--range", "3 deg"], "is not LOW .. HIGH"),
        (["--x", "alpha", "--where", "k = 3"], "is not NAME >= VALUE"),
        (["--x", "alpha", "--along", "beta"], "is not NAME = FORMULA"),
        (["--x", "alpha", "--along", "bata = alpha"], "did you mean 'beta'?"),
    ],
)
def test_lines_that_make_no_sense(line, said, capsys):
    assert main(["plot", CLAMP, *line]) == 2
    assert said in capsys.readouterr().err


def test_a_value_without_its_unit_is_one_of_the_usual_errors(capsys, clamp):
    assert main(["plot", CLAMP, "--x", "alpha", "--family", "beta=10,20"]) == 1
    assert "10 what? Expected an angle (deg)" in capsys.readouterr().err
    with pytest.raises(MechcError, match="E221"):
        clamp.plot("alpha", range=("1 mm", "2 mm"))


def test_a_stroke_without_a_drive_points_here(capsys):
    assert main(["stroke", CLAMP]) == 1
    assert "`mechc plot FILE --x alpha` runs over its range" in capsys.readouterr().err


SLOT = """
param phi = 90 deg in 20 deg .. 160 deg
pivot O at (0 mm, 0 mm)
pivot C at (0 mm, 150 mm)
link CA
link OE
CA = 50 mm @ phi
OE = 350 mm
slot A in OE
drive phi from 20 deg to 160 deg
torque M on CA
force F at E along x
friction contact A 0.3
friction pins 0.2 diameter 40 mm
find k = M/F
"""


def test_a_joint_at_rest_for_an_instant_has_the_friction_of_its_sides():
    """As pages and `check` have it: code at exactly this pose has no friction in the slot."""
    lever = mechc.loads(SLOT, "slot.mech")
    plot = lever.plot(y=["k_f", "eta_k"], points=3).plot
    beside = lever.evaluate(phi="90.0001 deg")
    for curve, column in zip(plot.curves, plot.columns[1:], strict=True):
        marks = [m.at.y for m in curve.marks if m.at.x == pytest.approx(math.pi / 2, abs=1e-9)]
        assert marks == pytest.approx([beside[curve.name]] * 2, rel=1e-5)
        assert column.values[1] == pytest.approx(marks[0], rel=1e-9)
        assert lever.evaluate()[curve.name] != pytest.approx(marks[0], rel=1e-3)


def test_of_nothing_but_rounding_zero_is_plotted():
    """Two cranks in gear move the point between two equal rods along x alone."""
    text = """
param a = 50 mm
param phi = 60 deg
param r = 12 mm
pivot O at (0 mm, 0 mm)
pivot Q at (0 mm, 2*r)
link OA
link QD
link AB
link DB
OA = a @ phi
QD = a @ -phi
AB = a
DB = a
gear O r, Q r
assembly ABD cw
drive phi from 20 deg to 65 deg
force F at B along y
torque M on OA
find k = M/F
"""
    cranks = mechc.loads(text)
    assert 0 < max(map(abs, cranks.evaluate(phi=np.radians(range(21, 65)))["k"])) < 1e-15
    plot = cranks.plot("phi").plot
    assert {p.y for curve in plot.curves for piece in curve.pieces for p in piece} == {0.0}
    assert set(plot.columns[1].values) == {0.0}


def test_an_extremum_far_below_a_pole_is_no_zero():
    """Values next to a pole are of any size, and do not say what is but rounding."""
    text = "sheet pole\nparam x = 2 in 0 .. 4\nlet y = (x - 1)^2 + 1/2 + 1/(x - 3)^2\n"
    (curve,) = mechc.loads(text).plot("x", ["y"]).plot.curves
    least = next(mark.at for mark in curve.marks if mark.kind == "minimum")
    assert least.y == pytest.approx((least.x - 1) ** 2 + 0.5 + (least.x - 3) ** -2)


def test_dead_centres_are_no_loads_across_a_velocity():
    rocker = loaded("crank_rocker").plot(language="uk")
    (curve,) = rocker.plot.curves
    assert list(curve.dead_centres) == [m.at.x for m in curve.marks if m.kind == "zero"]
    assert "phi = 24,15° (мертве положення)" in rocker.alt
    (cylinder,) = loaded("oscillating_cylinder").plot().plot.curves
    assert (len([m for m in cylinder.marks if m.kind == "zero"]), cylinder.dead_centres) == (1, ())
    (limit,) = loaded("double_rocker").plot(range=("60 deg", "100 deg")).plot.curves
    assert limit.dead_centres == limit.poles != ()


def test_plots_have_titles_in_the_language(clamp):
    assert "Пакетний затискач" in clamp.plot("alpha", language="uk").drawing.title
    ratio = mechc.loads(CRANK, "m.mech").plot("phi", range=("10 deg", "80 deg"))
    assert "M/F, mm" in lettering(ratio.drawing)
    assert ratio.alt.startswith("M/F against phi")


def test_a_report_plots_over_what_has_a_range():
    """Without one there is nothing to plot over; of two, one that the result depends on."""
    lever = "pivot O\nlink AOB\nOA = a @ 0\nOB = b @ 180 deg\nforce P at A along y\n"
    asked = "force F at B along y\nfind k = P/F\n"
    for a, expected in (("10 mm", None), ("10 mm in 5 mm .. 20 mm", "a")):
        text = f"mechanism m\nparam b = 40 mm\nparam a = {a}\n{lever}{asked}"
        made = Compilation(Source("m.mech", text))
        query = usual(made.mechanism, made.routine)
        assert (query and query.x) == expected


def test_what_is_along_the_axis_is_not_offered_for_a_family(clamp):
    with pytest.raises(MechcError) as error:
        clamp.plot("alpha", family={"alpha": ["10 deg"]})
    expected = error.value.diagnostics[0].message.partition("expected")[2]
    assert "beta" in expected
    assert "alpha" not in expected
