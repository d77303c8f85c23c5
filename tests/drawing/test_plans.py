"""Plans: velocities from a pole, forces head to tail; laws of mechanics hold in the picture."""

import math
from itertools import pairwise

import pytest

from good_mechanisms import ALL, begun
from mechc.cli import main
from mechc.compilation import Compilation
from mechc.drawing.drawing import Arc, Polyline
from mechc.drawing.moving import Marks
from mechc.drawing.paper import on_paper
from mechc.drawing.pens import FORCE, RELATIVE, SYMBOL, VELOCITY
from mechc.report.languages.en.pictured import WORDS as EN
from mechc.report.languages.ru.pictured import WORDS as RU
from mechc.report.languages.uk.pictured import WORDS as UK
from mechc.source import Source
from mechc.statics.diagrams.diagram import friction_circles
from readable_drawings import assert_readable, lettering, written

FEW = [
    "crank_rocker",
    "crank_shaper",
    "d45_06_double_wedge_with_friction",
    "d45_10_two_screws",
    "equalising_clamp",
    "karpenko_fig9_packet_clamp",
    "lazy_tongs",
    "oscillating_cylinder",
    "scotch_yoke",
]
"""One of each kind of joint, one with two independent motions."""


def arrows(drawing, pen):
    """Return the tails and tips of the arrows of a pen: a shaft is followed by its head."""
    return [
        (shaft.points[0], head.points[0])
        for shaft, head in pairwise(drawing.shapes)
        if shaft.pen == head.pen == pen and isinstance(shaft, Polyline) and head.fill == "solid"
    ]


@pytest.mark.parametrize("name", FEW)
def test_no_label_is_on_a_line(name):
    assert_readable(begun(name).drawn_plans("en"))


@pytest.mark.slow
@pytest.mark.parametrize("name", sorted({*ALL} - {*FEW})[::5])
def test_nor_in_many_others(name):
    assert_readable(begun(name).drawn_plans("en"))


@pytest.mark.parametrize("name", FEW)
def test_links_are_rigid(name):
    """The ends of a bar have equal projections on it, and differ by its rotation."""
    figure = begun(name).figure
    for velocities in begun(name).velocities:
        for part in figure.parts:
            if getattr(part, "rods", ()) and part.name in velocities.spins:
                for a, b in part.rods:
                    arm = figure.points[b].minus(figure.points[a])
                    turned = arm.turned().times(velocities.spins[part.name])
                    found = velocities.points[b].minus(velocities.points[a])
                    assert math.dist(found, turned) < 1e-9 * (1 + math.hypot(*found))


@pytest.mark.parametrize("name", ["crank_rocker", "crank_slider", "toggle_clamp", "watt_six_bar"])
def test_loads_do_no_work_together(name):
    """Forces come from free bodies, velocities from the plan: they know nothing of one another."""
    (velocities,) = begun(name).velocities
    loads = [
        (body, acting)
        for body in begun(name).free_bodies[0].bodies
        for acting in body.forces
        if acting.kind == "load"
    ]
    powers = [
        acting.force.dot(velocities.points[acting.point])
        if acting.point
        else acting.moment * velocities.spins[body.name]
        for body, acting in loads
    ]
    assert abs(sum(powers)) < 1e-9 * max(map(abs, powers))
    assert max(powers) > 1e-3


def test_the_drive_states_sense_and_size():
    """The crank of a crank slider at 10 rad/s, by hand: V_A = omega r, square to the crank."""
    text = """
mechanism crank_slider
param r = 50 mm
param l = 200 mm
param phi = 30 deg in 0 deg .. 360 deg
param w = 10 rad/s
pivot O at (0, 0)
slider B along x through O
link OA
link AB
OA = r @ phi
AB = l
assembly B forward
drive phi from 0 deg to 360 deg speed w
torque M on OA
force F at B along -x
find k = M/F
"""
    (velocities,) = Compilation(Source("crank.mech", text)).velocities
    assert velocities.per == ""
    assert velocities.speed("A") == pytest.approx(0.5)
    assert velocities.points["A"].angle == pytest.approx(math.radians(120))
    assert velocities.spins["OA"] == pytest.approx(10.0)


def test_arrows_of_velocities_meet_as_vectors_add():
    """V_B = V_A + V_BA: relative velocities lead from one tip to another."""
    drawing = begun("crank_rocker").drawn_plans("en")
    absolute, relative = arrows(drawing, VELOCITY), arrows(drawing, RELATIVE)
    assert len({tail for tail, _ in absolute}) == 1
    assert len(absolute) == 2
    ((tail, tip),) = relative
    assert {tail, tip} == {end for _, end in absolute}


@pytest.mark.parametrize(("name", "along"), [("scotch_yoke", 90.0), ("d45_16_wedge_hook", -10.0)])
def test_what_slides_on_a_slide_moves_along_its_face(name, along):
    """The pin of a yoke along the slot, the roller of a hook along the face of the wedge."""
    ((tail, tip),) = arrows(begun(name).drawn_plans("en"), RELATIVE)
    turn = tip.minus(tail).angle - math.radians(along)
    assert math.sin(turn) == pytest.approx(0, abs=1e-9)


@pytest.mark.parametrize("name", ["crank_slider", "karpenko_fig9_packet_clamp"])
def test_polygons_of_forces_close(name):
    sides = [tip.minus(tail) for tail, tip in arrows(begun(name).drawn_plans("en"), FORCE)]
    assert len(sides) > 5
    assert math.hypot(sum(s.x for s in sides), sum(s.y for s in sides)) < 1e-6


def test_scales_are_stated():
    """The bar below the polygon of velocities is as long as it says."""
    drawing = begun("crank_rocker").drawn_plans("en")
    (label,) = (one for one in drawing.labels if written(one) == "0.2\u2009VA")
    bar = min(
        (s for s in drawing.shapes if isinstance(s, Polyline) and s.points[0].y == s.points[1].y),
        key=lambda s: math.dist(s.points[1], label.at),
    )
    longest = max(math.dist(*side) for side in arrows(drawing, VELOCITY))
    assert math.dist(*bar.points) == pytest.approx(0.2 * longest)


def test_plans_speak_three_languages():
    drawn = begun("crank_rocker").drawn_plans
    assert "velocities" in lettering(drawn("en"))
    assert "швидкості" in lettering(drawn("uk"))
    assert "скорости" in lettering(drawn("ru"))
    assert EN.keys() == UK.keys() == RU.keys()
    assert "VB = 0.915\u2009VA ∠ 155°" in drawn("en").description


def test_what_is_chosen_has_no_size():
    """The length of BK is given by nothing, so that its angular velocity is not stated."""
    found = lettering(begun("karpenko_fig9_packet_clamp").drawn_plans("en"))
    assert "ωOBA = −4\u2009VA/m" in found
    assert not any("ωBK" in text for text in found)


def test_one_picture_at_a_time(capsys, tmp_path):
    target = tmp_path / "k.svg"
    assert main(["draw", "crank_rocker", "--plans", "--bodies"]) == 2
    assert "--bodies and --plans are two pictures" in capsys.readouterr().err
    assert main(["draw", "crank_rocker", "--plans", "--lang", "uk", "-o", str(target)]) == 0
    assert "Плани швидкостей і сил" in target.read_text("utf-8")


def test_at_a_dead_centre_there_is_nothing_to_plan(capsys, tmp_path):
    """E723: at beta = 0 the slider A, by which all is measured, stands still."""
    description = tmp_path / "dead.mech"
    description.write_text(
        "mechanism dead\nparam beta = 0 deg\nslider A along 0 deg\nslider B along 90 deg\n"
        "link AB\nAB = @ beta\nlet y = cos(beta)\n"
    )
    assert main(["draw", str(description), "--plans"]) == 1
    assert "E723" in capsys.readouterr().err
    assert main(["draw", str(description), "--plans", "-D", "beta=10deg"]) == 0


def test_centres_are_where_lines_square_to_velocities_meet():
    """That of the coupler lies on both rockers of a four-bar."""
    double, paper = begun("double_rocker"), on_paper(begun("double_rocker").figure)
    drawing = double.drawn_scheme("en", Marks(centres=double.velocities[0]))
    (cross, _) = (s for s in drawing.shapes if s.pen == SYMBOL and s not in double.scheme.shapes)
    centre = cross.points[0].plus(cross.points[1]).times(0.5)
    for pivot, pin in (("O1", "A"), ("O2", "B")):
        arm, to = (at.minus(paper.at(pivot)) for at in (paper.at(pin), centre))
        assert abs(arm.turned().dot(to)) < 1e-9 * math.hypot(*arm) * math.hypot(*to)


def test_friction_circles_are_as_large_as_they_are():
    lever = begun("lever_clamp_with_friction")
    radii, moving = friction_circles(lever.free_bodies), lever.velocities[0]
    drawing = lever.drawn_scheme("en", Marks(moving, moving, radii))
    assert_readable(drawing)
    circles = [s for s in drawing.shapes if isinstance(s, Arc) and s.pen == FORCE and s.whole]
    expected = [radius * on_paper(lever.figure).scale for radius in radii.values()]
    assert [circle.radius for circle in circles] == pytest.approx(expected)


def test_what_a_picture_says_is_in_the_language(capsys):
    assert main(["draw", "karpenko_fig9_packet_clamp", "--lang", "uk"]) == 0
    said = capsys.readouterr().out
    assert "Нерухомі шарніри: O, O'." in said
    assert "Показано обидві дзеркальні половини." in said
    assert main(["draw", "crank_rocker", "--lang", "ru", "--centres"]) == 0
    assert "Мгновенные центры скоростей слишком далеко" in capsys.readouterr().out
