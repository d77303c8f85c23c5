"""The scheme: no label on a line, symbols where points are, the same in SVG, TikZ and PNG."""

import importlib
import math
import re
import subprocess
import sys
import xml.etree.ElementTree as ET
from itertools import pairwise, product

import numpy as np
import pytest

import mechc
from good_mechanisms import ALL, begun
from grown import Grown
from mechc.cli import main, make_gallery
from mechc.compilation import Compilation
from mechc.diagnostics import MechcError
from mechc.drawing.drawing import Arc, Polyline
from mechc.drawing.from_figure import scheme
from mechc.drawing.lettering import name as lettering_of
from mechc.drawing.loads import meets
from mechc.drawing.moving import Marks
from mechc.drawing.occupied import Occupied
from mechc.drawing.paper import on_paper
from mechc.drawing.pens import BODY, COPY, FORCE, HATCH, MEASURE, SYMBOL, VELOCITY
from mechc.emit.svg.picture import to_png, to_svg
from mechc.emit.tikz.picture import to_tikz
from mechc.figure.figure import Actuator, Force, Spring, Torque
from mechc.files import find, mechanisms, read
from mechc.formula.names import split_points
from mechc.model.values import range_of
from mechc.report.languages.en.pictured import WORDS as EN
from mechc.source import Source
from readable_drawings import assert_readable, lettering, places
from sources import in_thirds

every_mechanism = pytest.mark.parametrize("name", in_thirds(ALL))

CLAMP = "karpenko_fig9_packet_clamp"


def drawn(name, **values):
    return scheme(begun(name).drawn(values), EN)


# ------------------------------------------------------------- where labels are


@pytest.mark.parametrize("name", in_thirds(ALL))
def test_no_label_is_on_a_line_or_touches_another(name):
    assert_readable(begun(name).scheme)


@pytest.mark.parametrize("seed", [*range(0, 60, 8)])
def test_nor_in_mechanisms_grown_at_random(seed):
    assert_grown_readable(seed)


@pytest.mark.slow
@pytest.mark.parametrize("seed", [*range(60, 360, 3), 1275])
def test_nor_in_many_of_them(seed):
    assert_grown_readable(seed)


def assert_grown_readable(seed):
    try:
        drawing = Compilation(Source("grown.mech", Grown(seed).text())).scheme
    except MechcError:
        return  # grown so that two closures cannot be told apart
    assert_readable(drawing)


# ----------------------------------------------------------------- what is drawn


@every_mechanism
def test_every_point_and_load_has_its_name(name):
    figure, found = begun(name).figure, lettering(begun(name).scheme)
    for point in figure.points:
        is_made = not split_points(point)  # it only tells where a guide lies
        assert is_made or "".join(run.text for run in lettering_of(point)) in found
    for part in figure.parts:
        if isinstance(part, Force | Torque | Actuator | Spring):
            name = "".join(run.text for run in lettering_of(part.name))
            assert any(name in text for text in found)


def test_measures_have_the_names_of_the_description():
    found = lettering(drawn(CLAMP))
    assert {"a", "b", "α", "β"} <= set(found)
    assert found.count("α") == 1
    assert {"50\u2009mm", "49\u2009mm", "7.8\u2009mm"} <= set(lettering(drawn("jansen_leg")))
    assert "h" in lettering(drawn("slider_crank_claw"))
    assert "−h" not in lettering(drawn("slider_crank_claw"))


def test_a_length_by_components_is_not_written_beside_its_bar():
    drawing = drawn("cartesian_rods")
    heads = [s for s in drawing.shapes if s.pen == MEASURE and s.fill == "solid"]
    assert len(heads) >= 4, "the arrows of two dimension lines"


@pytest.mark.parametrize("name", ["bell_crank", "four_bar", "lever_first_class", "wheelbarrow"])
def test_an_arrow_has_another_place_than_a_dimension_line(name):
    drawing = drawn(name)
    thin = Occupied(s for s in drawing.shapes if s.pen == MEASURE and isinstance(s, Polyline))
    assert not [shaft for shaft in shafts(drawing, FORCE) if meets(shaft, thin)]


def test_arrows_point_as_the_forces_do():
    drawing = drawn("crank_slider")
    heads = [s.points for s in drawing.shapes if s.pen == FORCE and isinstance(s, Polyline)]
    (force,) = [points for points in heads if len(points) == 3 and points[1].x == points[2].x]
    assert force[0].x > force[1].x, "to the right: the head's tip before its feet"


@pytest.mark.parametrize("name", in_thirds(ALL))
def test_no_velocity_is_drawn_along_a_load(name):
    moving = begun(name).velocities
    if not moving:
        pytest.skip("nothing that moves in one way only")
    drawing = begun(name).drawn_scheme("en", Marks(velocities=moving[0]))
    assert_readable(drawing)
    for velocity, load in product(shafts(drawing, VELOCITY), shafts(drawing, FORCE)):
        assert common_length(velocity, load) < 0.5


def shafts(drawing, pen):
    lines = [s.points for s in drawing.shapes if isinstance(s, Polyline) and s.pen == pen]
    return [points for points in lines if len(points) == 2]


def common_length(one, other):
    """Return how much of a line lies within half a millimetre of another of its direction."""
    start = np.array(one[0])
    along = (np.array(one[1]) - start) / math.dist(*one)
    ways = [(np.array(end) - start) for end in other]
    if any(abs(along[0] * y - along[1] * x) > 0.5 for x, y in ways):
        return 0.0
    low, high = sorted(float(along @ way) for way in ways)
    return min(math.dist(*one), high) - max(0.0, low)


def test_halves_are_in_one_place_or_clearly_in_two():
    for name in mechanisms():
        figure = begun(name).figure
        if figure.mirror is None or not figure.chosen:
            continue
        for point, at in figure.points.items():
            twin = figure.points.get(f"{point}'", at)
            assert not 1e-6 < math.dist(at, twin) / figure.size < 0.15, f"{name}: {point}"


@pytest.mark.parametrize("angle", [12, 25, 35])
def test_a_half_stays_on_its_side_where_a_length_is_open(angle):
    """With beta = 7 deg a link BK that is too short brings the pivot O across the mirror line."""
    points = begun(CLAMP).drawn({"alpha": math.radians(angle)}).points
    assert all(points[name].x > points["K"].x + 1e-9 for name in "OAB")


def test_the_ground_of_a_pivot_is_off_its_bars():
    for name in mechanisms():
        figure = begun(name).figure
        links = [p for p in figure.parts if type(p).__name__ == "Link"]
        for pivot in (p for p in figure.parts if type(p).__name__ == "Pivot"):
            for tail, head in (rod for link in links for rod in link.rods):
                if pivot.point in (tail, head):
                    other = head if pivot.point == tail else tail
                    way = figure.points[other].minus(figure.points[pivot.point]).unit()
                    assert way.dot(pivot.ground) < math.cos(math.radians(30)), name


@pytest.mark.parametrize(("name", "is_ring"), [("planetary_ring", True), ("belt_on_arm", False)])
def test_a_wheel_that_stands_still_is_hatched_where_the_ground_is(name, is_ring):
    shapes = drawn(name).shapes
    (rim,) = [s for s in shapes if isinstance(s, Arc) and s.pen == SYMBOL and abs(s.sweep) < 6]
    hatches = [s.points for s in shapes if isinstance(s, Polyline) and s.pen == HATCH]
    on_rim = [p for p in hatches if math.dist(p[0], rim.centre) == pytest.approx(rim.radius)]
    assert len(on_rim) >= 5
    assert all((math.dist(tip, rim.centre) > rim.radius) == is_ring for _, tip in on_rim)


def test_no_measure_is_negative_and_no_angle_is_there_twice():
    for name in mechanisms():
        parts = begun(name).figure.parts
        assert all(p.value > 0 for p in parts if type(p).__name__ == "Dimension"), name
        marks = [(p.vertex, p.text, round(math.tan(p.start), 6), round(p.sweep, 6)) for p in parts
                 if type(p).__name__ == "AngleMark"]  # fmt: skip
        assert len(marks) == len(set(marks)), name


def test_all_copies_are_drawn():
    three = [s for s in drawn("three_claw_gripper").shapes if s.pen == COPY]
    one = [s for s in drawn("slider_crank_claw").shapes if s.pen == COPY]
    assert len(three) == 3, "two branches behind each other, with three bars each"
    assert one == []


def test_wedges_reach_their_rollers():
    for name in ("d45_05_wedge_roller_lever", "d45_16_wedge_hook", "wedge_drive"):
        drawing = drawn(name)
        (wedge,) = [s for s in drawing.shapes if getattr(s, "closed", False) and s.fill == "light"]
        rollers = [s for s in drawing.shapes if isinstance(s, Arc) and s.radius == 1.9]
        for roller in rollers:
            away = np.hypot(*(places(wedge) - np.array(roller.centre)).T).min()
            assert away == pytest.approx(roller.radius, abs=0.01)


# ------------------------------------------------------------------- the formats


def test_svg_is_a_picture_with_a_text_for_who_cannot_see_it():
    root = ET.fromstring(to_svg(drawn(CLAMP)))
    space = "{http://www.w3.org/2000/svg}"
    assert root.get("role") == "img"
    assert root.find(f"{space}title").text == "Packet clamp of a profile-welding machine"
    about = root.find(f"{space}desc").text
    assert "Links: OBA, BK, O'B'A', B'K." in about
    assert "P at A, F at K, P at A'" in about
    assert "Not to scale: nothing gives BK." in about
    assert {child.tag.removeprefix(space) for child in root.iter()} <= {
        "svg", "title", "desc", "rect", "g", "path", "text", "tspan",
    }  # fmt: skip


def test_svg_and_tikz_show_the_same():
    drawing = drawn(CLAMP)
    svg, tikz = to_svg(drawing), to_tikz(drawing)
    assert svg.count("<text") == tikz.count(r"\node") == len(drawing.labels)
    assert len(re.findall(r"M", "".join(re.findall(r'd="([^"]*)"', svg)))) == len(drawing.shapes)
    assert tikz.count(r"\path[") == len(drawing.shapes)


HOSTILE = """
mechanism m "</title><script>alert(1)</script>&\x00]]>% \\input{x} ${x}"
param l = 40 mm
pivot O
link OA
OA = l @ 30 deg
force P at A along y
torque M on OA
find k = M/P
"""


def test_hostile_names_run_nothing():
    text = HOSTILE.replace("\x00", "")
    drawing = Compilation(Source("m.mech", text)).scheme
    root = ET.fromstring(to_svg(drawing))
    assert not [e for e in root.iter() if "script" in e.tag]
    assert root[0].text.startswith("</title><script>")
    code = [line.split("%")[0] for line in to_tikz(drawing).splitlines()]
    assert not [line for line in code if "input" in line or "script" in line]


def test_png(tmp_path):
    pytest.importorskip("typst")
    assert main(["draw", "crank_slider", "-o", str(tmp_path / "k.png")]) == 0
    assert (tmp_path / "k.png").read_bytes().startswith(b"\x89PNG")


def test_png_without_its_library(monkeypatch, tmp_path, capsys):
    """E721: nothing is written."""
    monkeypatch.setitem(sys.modules, "typst", None)
    importlib.invalidate_caches()
    with pytest.raises(MechcError, match="PNG cannot be written"):
        to_png(drawn("crank_slider"))
    paths = [str(tmp_path / name) for name in ("k.svg", "k.png")]
    assert main(["draw", "crank_slider", "-o", paths[0], "-o", paths[1]]) == 3
    assert "pip install 'mechc[png]'" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


# -------------------------------------------------------------------- the command


def test_the_command_writes_what_the_suffix_says(tmp_path, capsys):
    paths = [tmp_path / "k.svg", tmp_path / "k.tex"]
    assert main(["draw", "crank_rocker", *(f"-o{path}" for path in paths)]) == 0
    assert paths[0].read_text("utf-8").startswith("<svg")
    assert r"\documentclass[tikz]{standalone}" in paths[1].read_text("utf-8")
    assert main(["draw", "crank_rocker"]) == 0
    assert capsys.readouterr().out == paths[0].read_text("utf-8")
    assert main(["draw", "crank_rocker", "-o", "-", "-Dphi=120deg"]) == 0
    assert capsys.readouterr().out != paths[0].read_text("utf-8")
    assert main(["draw", "crank_rocker", "-o", "k.bmp"]) == 2


def test_what_cannot_be_assembled_is_not_drawn(tmp_path, capsys):
    """E720 where halves do not meet, E704 of a sheet; an open loop is an error of the pose."""
    text = """
        mechanism rhombus
        param alpha = 35 deg
        slider A along x
        pivot O
        link AB
        link BO
        AB = 40 mm @ alpha
        BO = 40 mm @ 90 deg
        mirror across 0 deg sharing A O
        force P at A along x
        force F at B along y
        find k = P/F
    """
    (tmp_path / "empty.mech").write_text("mechanism m\nparam a = 1 m\nlet b = a\n")
    (tmp_path / "r.mech").write_text(text)
    assert main(["draw", str(tmp_path / "empty.mech")]) == 1
    assert "E704" in capsys.readouterr().err
    target = tmp_path / "r.svg"
    target.write_text("as it was")
    assert main(["draw", str(tmp_path / "r.mech"), "-o", str(target)]) == 1
    assert "E720" in capsys.readouterr().err
    assert target.read_text() == "as it was"


@pytest.mark.parametrize("hash_seed", ["77"])
def test_the_same_bytes_for_any_hash(hash_seed):
    code = (
        "from mechc.compilation import Compilation as C; from mechc.files import find, read;"
        "from mechc.emit.svg.picture import to_svg;"
        "print(*(to_svg(C(read(find(n))).scheme)"
        " for n in ('parallel_gripper', 'scissor_2', 'jansen_leg')), sep='')"
    )
    names = ("parallel_gripper", "scissor_2", "jansen_leg")
    here = "".join(to_svg(Compilation(read(find(name))).scheme) for name in names)
    run = subprocess.run(
        [sys.executable, "-c", code],
        env={"PYTHONHASHSEED": hash_seed, "PYTHONPATH": ":".join(sys.path), "PYTHONUTF8": "1"},
        capture_output=True,
        check=True,
    )
    assert run.stdout.decode() == here + "\n"


# -------------------------------------------------------------------- the gallery


@pytest.mark.parametrize("name", mechanisms())
def test_the_gallery_shows_the_library_as_it_is(name):
    made = (make_gallery.folder() / f"{name}.svg").read_text(encoding="utf-8")
    assert made == to_svg(begun(name).scheme), "python -m mechc.cli.make_gallery"


def test_the_gallery_has_all_mechanisms_and_no_others():
    titles = {name: begun(name).scheme.title for name in mechanisms()}
    readme = (make_gallery.folder().parent / "README.md").read_text(encoding="utf-8")
    assert readme.endswith(make_gallery.section(titles)), "python -m mechc.cli.make_gallery"
    assert {path.stem for path in make_gallery.folder().iterdir()} == set(titles)


# ---------------------------------------------------------------------- from Python


def test_a_picture_saves_itself_and_shows_itself(tmp_path):
    picture = mechc.load("crank_rocker").draw(phi=math.radians(120))
    picture.save(tmp_path / "k.svg")
    assert (tmp_path / "k.svg").read_text("utf-8") == picture._repr_svg_()
    assert picture._repr_svg_() != mechc.load("crank_rocker").draw()._repr_svg_()
    with pytest.raises(ValueError, match=r"none of the suffixes \.svg"):
        picture.save(tmp_path / "k.bmp")


def test_a_picture_speaks_a_language():
    drawing = mechc.load("crank_rocker").draw(language="uk", phi=math.radians(120)).drawing
    assert "кривошип" in drawing.title.lower()
    assert "Нерухомі шарніри: O1, O2" in drawing.description
    russian = mechc.load("whitworth").draw(language="ru").drawing.description
    assert russian.endswith("Не в масштабе: не заданы QC.")


@pytest.mark.slow
@pytest.mark.parametrize("name", ["double_crank", "whitworth"])
def test_along_the_stroke_the_drawing_does_not_jump(name):
    """Two hundred poses: no point moves by a twentieth of the paper from one to the next."""
    compilation = begun(name)
    drive = compilation.pose.mechanism.drive.parameter
    low, high = range_of(drive, compilation.pose.mechanism)
    places = [low + (high - low) * i / 200 for i in range(201)]
    papers = [on_paper(compilation.drawn({drive: place})) for place in places]
    for before, after in pairwise(papers):
        moved = [math.dist(before.at(p), after.at(p)) for p in before.figure.points]
        assert 0 < max(moved) < 6.0


def test_a_couple_has_its_name_next_to_its_arrow():
    """Below a slide, over a short wheel: the name stood above the rack."""
    drawing = drawn("table_4_4_gear")
    label = next(one for one in drawing.labels if one.runs == lettering_of("M"))
    arcs = [s for s in drawing.shapes if isinstance(s, Arc) and s.pen == FORCE]
    assert min(math.dist(at, label.at) for arc in arcs for at in arc.way()) < 7.0
    assert not any(
        isinstance(s, Polyline)
        and s.pen == HATCH
        and len(s.points) == 2
        and math.dist(s.points[1], label.at) < 4
        for s in drawing.shapes
    )


def test_a_filled_body_covers_no_rod() -> None:
    """The plate of a yoke hid the crank that drives it."""
    yoke = """
    mechanism yoke
    param r = 50 mm
    param phi = 35 deg
    pivot O at (0 mm, 0 mm)
    link OA
    slide XYZ along x
    slot A in YZ
    OA = r @ phi
    YZ = @ 90 deg
    torque M on OA
    force F at X along -x
    find k = M/F
    """
    shapes = scheme(Compilation(Source("yoke.mech", yoke)).drawn({}), EN).shapes
    lines = [shape for shape in shapes if isinstance(shape, Polyline)]
    (plate,) = (i for i, shape in enumerate(lines) if shape.fill == "light")
    crank = next(i for i, shape in enumerate(lines) if shape.pen == BODY and not shape.closed)
    assert plate < crank
