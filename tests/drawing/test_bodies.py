"""Free-body diagrams: every force of the data, to scale, at its place, with its name."""

import math
from itertools import pairwise

import pytest

from good_mechanisms import ALL, begun
from mechc.cli import main
from mechc.compilation import Compilation
from mechc.drawing.drawing import Arc, Polyline
from mechc.drawing.language_letters import in_letters
from mechc.drawing.pens import AXIS, FORCE
from mechc.drawing.symbols import LARGEST_ARROW, SHORTEST_ARROW
from mechc.formula.letters import letters
from mechc.report.languages.en.pictured import WORDS as EN
from mechc.report.languages.registry import locale
from mechc.report.languages.ru.pictured import WORDS as RU
from mechc.report.languages.uk.pictured import WORDS as UK
from mechc.source import Source
from mechc.statics.verdict import WITHOUT_FORCES
from readable_drawings import assert_readable, lettering

FEW = [
    "claw_with_friction",
    "crank_rocker",
    "d45_05_wedge_roller_lever_with_friction",
    "d45_12_worm_sectors",
    "equalising_clamp",
    "fedoriv_fig2b_with_friction",
    "karpenko_fig9_packet_clamp",
    "oscillating_cylinder",
    "scotch_yoke",
    "three_claw_gripper",
]
"""One of each kind of body, joint and load."""


@pytest.mark.parametrize("name", FEW)
def test_no_label_is_on_a_line(name):
    assert_readable(begun(name).drawn_bodies("en"))


WITHOUT = ("speeds", "plate_clutch")
"""In the one no load is asked for, in the other nothing but friction holds the only one."""


@pytest.mark.slow
@pytest.mark.parametrize("name", ALL)
def test_nor_in_all_others(name):
    drawing = begun(name).drawn_bodies("en")
    assert drawing is not None or name in WITHOUT
    if drawing is not None:
        assert_readable(drawing)


def arrows(drawing):
    """Yield tails and tips: the shaft of an arrow is followed by its head."""
    for shaft, head in pairwise(drawing.shapes):
        if shaft.pen == head.pen == FORCE and isinstance(shaft, Polyline) and head.fill == "solid":
            yield shaft.points[0], head.points[0]


def test_forces_are_to_scale_and_point_as_they_act():
    name = "karpenko_fig9_packet_clamp"
    (diagram,) = begun(name).free_bodies
    bodies = [b for b in diagram.bodies if not (b.kind == "link" and b.name.endswith("'"))]
    forces = [a.force for b in bodies for a in b.forces if a.force and math.hypot(*a.force) > 1e-9]
    largest = max(math.hypot(*force) for force in forces)
    expected = [
        (round(force.angle, 6), max(SHORTEST_ARROW, LARGEST_ARROW * math.hypot(*force) / largest))
        for force in forces
    ]
    found = [tip.minus(tail) for tail, tip in arrows(begun(name).drawn_bodies("en"))]
    drawn = [(round(arrow.angle, 6), math.hypot(*arrow)) for arrow in found]
    for one, other in zip(sorted(drawn), sorted(expected), strict=True):
        assert one == pytest.approx(other)


def test_forces_have_names_and_sizes():
    found = lettering(begun("karpenko_fig9_packet_clamp").drawn_bodies("en"))
    assert {"F", "P = 0.0671\u2009F", "RO = 0.5\u2009F"} <= set(found)
    assert "k, without friction, forces per unit of F" in found


def test_a_couple_of_friction_has_a_name_of_its_own():
    clutch = lettering(begun("plate_clutch").drawn_bodies("en"))
    assert {"M = 236\u2009N·m", "Mfr = 236\u2009N·m"} <= set(clutch)
    assert not any("without friction" in label for label in clutch)
    jack = lettering(begun("screw_jack_with_collar").drawn_bodies("en"))
    assert [label for label in jack if label.startswith("MA")]
    assert "Ffr,A = 0.00684\u2009F" in jack
    planets = lettering(bodies_in("uk", "planetary_gear"))
    assert "Mстояк = 0,3\u2009T" in planets


def bodies_in(language, name):
    drawing = begun(name).drawn_bodies(language)
    return in_letters(drawing, letters(locale(language)))


@pytest.mark.parametrize(
    ("name", "drawn"),
    [
        ("d45_11_screw_lever_with_friction", {"2N", "RO = 10\u2009N"}),
        ("scissor_table", {"W/2", "W2/2 = 0.5\u2009W"}),
        ("three_claw_gripper", {"P/3 = 1.4\u2009R", "T = 0.2\u2009R"}),
    ],
)
def test_a_load_has_its_name_as_often_as_it_acts(name, drawn):
    found = set(lettering(begun(name).drawn_bodies("en")))
    assert drawn <= found
    assert {run.split("=")[0] for run in drawn} & {"N", "W", "P "} == set()


def test_a_couple_per_unit_of_a_force_is_an_arm_times_the_force():
    assert "M = 120\u2009mm·F" in lettering(begun("four_bar").drawn_bodies("en"))
    assert "M = 36,6\u2009мм·F" in lettering(bodies_in("uk", "crank_rocker"))


def test_points_in_indices_are_points():
    drawing = begun("four_bar").drawn_bodies("en")
    (index,) = {label.runs[1:3] for label in drawing.labels if lettered(label).startswith("RO1 = ")}
    assert [(run.text, run.italic, run.level) for run in index] == [
        ("O", True, -1),
        ("1", False, -2),
    ]


def lettered(label):
    return "".join(run.text for run in label.runs)


def test_friction_circles_are_as_large_as_they_are():
    figure, scale = begun("lever_clamp_with_friction").figure, None
    drawing = begun("lever_clamp_with_friction").drawn_bodies("en")
    plain, with_friction = begun("lever_clamp_with_friction").free_bodies
    (offset,) = {abs(a.offset) for b in with_friction.bodies for a in b.forces if a.offset}
    (circle,) = [s for s in drawing.shapes if isinstance(s, Arc) and s.pen == AXIS]
    scale = circle.radius / offset
    lever = max(math.dist(s.points[0], s.points[1]) for s in drawing.shapes if s.pen.name == "body")
    bar = max(math.dist(figure.points["O"], figure.points[p]) for p in "AB")
    assert plain.motion == ""
    assert lever == pytest.approx(scale * bar)


def test_of_halves_one_is_drawn():
    drawing = begun("karpenko_fig9_packet_clamp").drawn_bodies("en")
    assert "Every body of one mirrored half" in drawing.description
    assert lettering(drawing).count("A") == 1
    assert "A'" not in lettering(drawing)


def test_without_loads_there_are_no_bodies(capsys, tmp_path):
    """E722."""
    target = tmp_path / "k.svg"
    assert main(["draw", str(ALL["speeds"]), "--bodies", "-o", str(target)]) == 1
    assert "there are no free bodies" in capsys.readouterr().err
    assert not target.exists()
    assert main(["draw", "crank_rocker", "--bodies", "-o", str(target)]) == 0
    assert "Free bodies of" in target.read_text("utf-8")


BENCH = """mechanism bench "Crank"
translate "Crank" uk "Кривошип" ru "Кривошип"
param phi = 60 deg
pivot O
slider B along 0 deg through (0 mm, 0 mm)
link OA
link AB
OA = 100 mm @ phi
AB = @ -17 deg
torque M on OA
force F at B along 180 deg
let F = 26.8 kN
find M/F
"""


def bench(language):
    compilation = Compilation(Source("bench.mech", BENCH))
    return compilation, in_letters(compilation.drawn_bodies(language), letters(locale(language)))


def test_names_and_units_are_as_they_are_written():
    compilation, drawing = bench("uk")
    found = lettering(drawing)
    assert "M/F, без тертя" in found
    assert "F = 26,8\u2009кН" in found
    assert drawing.title == "Ланки, звільнені від в’язей: Кривошип"
    assert "M/F" in drawing.description
    (diagram,) = compilation.free_bodies
    assert [body.name for body in diagram.bodies] == ["OA", "AB", "B"]


def test_why_there_are_no_forces_is_said_in_three_languages():
    assert all(words.keys() >= {*WITHOUT_FORCES} for words in (EN, UK, RU))


def test_what_equals_a_load_has_no_number():
    found = lettering(begun("block_and_tackle").drawn_bodies("uk"))
    assert "RK = F" in found
    assert any(text.startswith("RA,стояк") for text in found)
    assert any(text.startswith("RA,кан") for text in found)


@pytest.mark.parametrize(("language", "words"), [("en", EN), ("uk", UK), ("ru", RU)])
def test_a_question_mark_is_explained(language, words):
    written = lettering(begun("roberval_balance").drawn_bodies(language))
    assert any("= ?" in text for text in written)
    assert any(text.endswith(f"; {words['undetermined']}") for text in written)
    determined = lettering(begun("crank_rocker").drawn_bodies(language))
    assert not any(words["undetermined"] in text for text in determined)


LEVER = """
param a = 8 in
pivot O
link OA
OA = a @ 180 deg
force P at A along -y
torque M on OA
find P
let M = {moment}
"""


@pytest.mark.parametrize(
    ("moment", "shown"),
    [
        ("120 lbf*in", {"P = 15\u2009lbf", "M = 120\u2009lbf·in"}),
        ("10 ft*lbf", {"P = 15\u2009lbf", "M = 120\u2009lbf·in"}),
        ("13.56 N*m", {"P = 66.7\u2009N", "M = 13.6\u2009N·m"}),
    ],
)
def test_forces_are_in_the_unit_of_the_description(moment, shown):
    compilation = Compilation(Source("lever.mech", LEVER.format(moment=moment)))
    assert shown <= set(lettering(compilation.drawn_bodies("en")))


SPINDLE = """
param p = 4 mm
pivot S at (-2 m, -0.06 m)
slider A along x
link SH
A at (-0.09 m, -0.06 m)
H at (-2 m, 0 mm)
screw A pitch p on SH
torque M on SH
force F at A along -x
force W = F/2000 at A along -x
find k = M/F
"""


def test_what_is_small_beside_the_largest_force_is_drawn():
    """M is a three thousandth of the moments that F could have: without it a link has no load."""
    found = lettering(Compilation(Source("spindle.mech", SPINDLE)).drawn_bodies("en"))
    assert {"M = 0.637\u2009mm·F", "MA = 0.637\u2009mm·F", "W = 0.0005\u2009F"} <= set(found)
