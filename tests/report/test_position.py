"""Position: every name of a closed loop is introduced before it is used, from the loop it is of."""

import math
from typing import get_args

import pytest

from good_mechanisms import CLOSED, compiled, loaded
from mechc.compilation import Compilation, emit
from mechc.emit.latex.to_latex import TARGET
from mechc.emit.target import Options
from mechc.formula.names import direction_of, split_points
from mechc.formula.to_text import text
from mechc.formula.walk import symbols
from mechc.model.values import completed, defaults
from mechc.report.definitions import SolvedSystem, grouped, without_minus
from mechc.report.kinds import PositionKind
from mechc.report.languages.registry import locale
from mechc.report.sections import outline
from mechc.report.sentences.speller import own_names
from mechc.report.sentences.wording import position_sentences
from mechc.report.steps import PositionStep
from mechc.report.text.derivation import render
from mechc.report.text.speller import speller
from mechc.source import Source
from small_mechanisms import slider_crank


def steps(name):
    return compiled(name).derivation.position


def test_a_four_bar_is_one_triangle_and_its_vertices_state_the_assembly():
    (step,) = steps("crank_rocker")
    assert (step.kind, step.points, step.is_clockwise) == ("triangle", ("O2", "B", "A"), False)
    assert [d.name for d in step.definitions] == ["len_AO2", "phi_AO2", "mu_B", "psi", "theta"]


@pytest.mark.parametrize(
    ("name", "kinds"),
    [
        ("whitworth", ["aligned", "inclination"]),
        ("jansen_leg", ["triangle"] * 5),
        ("triad_closed", ["system"]),
    ],
)
def test_each_loop_is_of_its_kind(name, kinds):
    assert [step.kind for step in steps(name)] == kinds


@pytest.mark.parametrize("language", ["en", "ru", "uk"])
@pytest.mark.parametrize("kind", get_args(PositionKind))
def test_a_kind_of_loop_that_comes_again_is_said_of_its_own_points(kind, language):
    loops = [
        PositionStep(kind, points, is_clockwise=True, definitions=(), like=("E", "F", "G"))
        for points in (("A", "B", "C"), ("R", "S", "T"))
    ]
    spell = speller((), compiled("four_bar").pose.mechanism, False, language)
    _, again = position_sentences(loops, locale(language), spell)
    assert "RST" in again or "R, S" in again


QUICK_RETURN = """
mechanism quick
param phi = 40 deg
param psi: angle
pivot O at (0 mm, 0 mm)
pivot C at (0 mm, -50 mm)
link OA
link CB
slot A in CB
OA = 120 mm @ phi
CB = 80 mm @ psi + 180 deg
drive phi from 0 deg to 180 deg
torque M on OA
force Q at B along x
find k = M/Q
"""


def test_a_slot_whose_direction_has_a_name_is_along_the_vector_that_gives_it():
    compilation = Compilation(Source("quick.mech", QUICK_RETURN))
    (step,) = compilation.derivation.position
    assert [d.name for d in step.definitions] == ["len_AC", "phi_AC", "psi"]
    spell = speller((), compilation.mechanism, False, "en")
    (said,) = position_sentences([step], locale("en"), spell)
    assert said.startswith("Loop CAO: the slot has the direction of the vector AC,")


SLIDER = slider_crank("find k = M/F", l="3*r", phi="40 deg", drive="")


def test_a_place_on_a_guide_that_nothing_needs_is_not_spoken_of():
    (step,) = Compilation(Source("m.mech", SLIDER)).derivation.position
    assert (step.kind, [d.name for d in step.definitions]) == ("inclination", ["beta_AB"])


def test_congruent_triangles_are_solved_once():
    first, second, _ = steps("peaucellier_closed")
    assert [d.name for d in first.definitions] == ["len_OA", "phi_OA", "mu_B", "phi_AB"]
    assert (second.kind, second.points) == ("congruent", ("A", "C", "O"))
    assert second.like == first.points == ("A", "B", "O")
    assert [d.name for d in second.definitions] == ["phi_AC"]


@pytest.mark.parametrize(
    ("language", "sentence"),
    [
        (
            "en",
            "Triangles ACO and ABO are congruent by their three sides: their angles at C and B "
            "are equal.",
        ),
        ("uk", "Трикутники ACO та ABO рівні за трьома сторонами: їхні кути при C та B рівні."),
        ("ru", "Треугольники ACO и ABO равны по трём сторонам: их углы при C и B равны."),
    ],
)
def test_it_is_said_by_what_triangles_are_congruent(language, sentence):
    compilation = compiled("peaucellier_closed")
    spell = speller(compilation.results, compilation.mechanism, True, language)
    said = list(position_sentences(steps("peaucellier_closed"), locale(language), spell))
    assert said[1] == sentence


@pytest.mark.parametrize("name", CLOSED)
def test_a_name_stands_before_what_uses_it(name):
    compilation = compiled(name)
    found = {n for loop in compilation.pose.solved for n in loop.names}
    whole = outline(compilation.derivation, compilation.mechanism)
    met = set()
    for section in whole.position:
        met |= {d.name for d in section.where}
        for definition in section.where:
            assert symbols(definition.formula) & found <= met
    for step in compilation.derivation.steps:
        for equation in (*step.relations, *step.results):
            assert symbols(equation.right) & found <= met
    assert not met & {d.name for section in whole.results for d in section.where}


def test_a_vector_that_is_a_sum_is_introduced_before_velocities_name_its_direction():
    (step,) = steps("sum_direction")
    assert (step.kind, step.points) == ("sum", ("O", "C"))
    assert [d.name for d in step.definitions] == ["phi_OC", "len_OC"]
    assert steps("let_geometry") == ()


BY_NUMBERS = """
param phi = 30 deg
param psi: angle
param theta: angle
pivot O1 at (0 mm, 0 mm)
pivot O2 at (120 mm, 0 mm)
link O1A
link AB
link O2B
O1A = 50 mm @ phi
AB = {coupler} mm @ psi
O2B = 50 mm @ theta
assembly ABO2 cw
drive phi from 10 deg to 80 deg
torque M on O1A
torque T on O2B
find k = M/T
"""


@pytest.mark.parametrize(("coupler", "kind"), [("120", "parallelogram"), ("119", "triangle")])
def test_what_follows_from_equal_numbers_is_said(coupler, kind):
    """In a parallelogram the rocker stands as the crank does, and no law of cosines says so."""
    source = Source("m.mech", BY_NUMBERS.format(coupler=coupler))
    derivation = Compilation(source).derivation
    assert [step.kind for step in derivation.position] == [kind]


def test_directions_that_vectors_have_put_in_are_said_where_they_were_found():
    """The bars of a rhombus are parallel, which velocities rest on without naming them."""
    *_, last = steps("peaucellier_closed")
    assert (last.kind, last.points) == ("rhombus", ("A", "B", "P", "C"))
    shown = {d.name: text(d.formula) for d in last.definitions}
    assert shown == {"phi_BP": "phi - phi_AB", "phi_CP": "phi_AB"}


@pytest.mark.parametrize(
    ("rod", "kind", "points"),
    [("r", "isosceles", ("O", "A", "B")), ("l", "inclination", ("O", "B", "A"))],
)
def test_a_slider_crank_of_two_equal_bars_is_an_isosceles_triangle(rod, kind, points):
    text = slider_crank("find k = M/F", drive="").replace("AB = l", f"AB = {rod}")
    (step,) = Compilation(Source("m.mech", text)).derivation.position
    assert (step.kind, step.points) == (kind, points)


def test_a_direction_that_equal_bars_alone_give_is_stated():
    """The bars of the table meet in their middles: each is inclined by half the angle there."""
    *_, last = steps("scissor_table")
    assert (last.kind, last.points) == ("isosceles", ("A", "M", "B"))
    assert {d.name: text(d.formula) for d in last.definitions} == {"phi_AM": "gamma_M/2"}


def test_loops_of_equal_bars_are_stated_where_forces_alone_lead_to_the_load():
    text = slider_crank("find k = M/F", drive="").replace("AB = l", "AB = r")
    derivation = Compilation(Source("m.mech", text)).by_equilibrium
    assert [step.kind for step in derivation.position] == ["isosceles"]


@pytest.mark.parametrize(
    ("language", "sentence"),
    [
        ("en", "Triangle OBK is isosceles, OB = BK: its directions follow at once."),
        ("uk", "Трикутник OBK рівнобедрений, OB = BK, тож напрями визначаються безпосередньо."),
        (
            "ru",
            "Треугольник OBK равнобедренный, OB = BK, поэтому направления определяются "
            "непосредственно.",
        ),
    ],
)
def test_it_is_said_which_figure_equal_sides_make(language, sentence):
    step = PositionStep("isosceles", ("O", "B", "K"), None, ())
    spell = speller((), compiled("four_bar").pose.mechanism, True, language)
    assert list(position_sentences([step], locale(language), spell)) == [sentence]


@pytest.mark.parametrize(("language", "word"), [("en", "rhombus"), ("uk", "ромб"), ("ru", "ромб")])
def test_a_parallelogram_of_equal_sides_is_a_rhombus(language, word):
    compilation = compiled("peaucellier_closed")
    spell = speller(compilation.results, compilation.mechanism, True, language)
    *_, said = position_sentences(steps("peaucellier_closed"), locale(language), spell)
    assert "ABPC" in said
    assert word in said
    assert [step.kind for step in steps("gripper_closed")][1] == "parallelogram"


UNNAMED = """
param phi = 60 deg
pivot O at (0 mm, 0 mm)
pivot Q at (300 mm, 400 mm)
link OA
link QBD
link AB
OA = 200 mm @ phi
QB = 200 mm
AB = 500 mm
QD = 900 mm @ QB
assembly ABQ cw
torque M on OA
force F at D along -y
find k = M/F
"""


def test_a_parallelogram_is_one_before_any_velocity():
    (step,) = Compilation(Source("m.mech", UNNAMED)).derivation.position
    assert step.kind == "parallelogram"
    shown = {d.name: text(d.formula) for d in step.definitions}
    assert shown == {"phi_QB": "phi", "phi_AB": "atan2(y_Q, x_Q)"}


TWO_IN_A_SLOT = """
pivot O at (0 mm, 0 mm)
pivot P at (69 mm, -29 mm)
link OA
link PC
link AE
slot A in PC
slot E in PC
A at (34 mm, 37 mm)
C at (-1 mm, 103 mm)
E at (16.5 mm, 70 mm)
torque M on OA
actuator F between P and E
drive OA from -100 deg to 190 deg
find k = M/F
"""


def test_a_vector_whose_drawn_length_has_its_name_is_one_sum():
    """The length PE that moves is not the drawn one, and is called len_PE_."""
    derivation = Compilation(Source("m.mech", TWO_IN_A_SLOT)).derivation
    *_, step = derivation.position
    assert (step.kind, step.points) == ("sum", ("P", "E"))
    assert [d.name for d in step.definitions] == ["phi_PE", "len_PE_"]


SLOT = """
mechanism slot
param phi = 25 deg in 5 deg .. 60 deg
param g = 180 mm
pivot O at (0 mm, 0 mm)
slider A along y through (g, 0 mm)
link OB
slot A in OB
OB = 300 mm @ phi
force P at A along y
force F at B along phi - 90 deg
find k = P/F
"""


def test_a_length_that_stands_in_velocities_by_its_formula_is_found_before_them():
    """g/cos φ stands for OA, which no description gives."""
    derivation = Compilation(Source("slot.mech", SLOT)).derivation
    (step,) = derivation.position
    assert [(d.name, text(d.formula)) for d in step.definitions] == [("len_OA", "g/cos(phi)")]
    assert text(derivation.steps[0].relations[0].left) == "g*omega_OB/cos(phi)"
    by_sums = Compilation(Source("slot.mech", SLOT)).by_equilibrium
    assert by_sums.position == derivation.position


LOOKED_UP = """
param v = 1.2 in 0 .. 3
list sizes = 80 mm, 120 mm, 200 mm
let a = 50 mm when v < 2 else 30 mm
let b = next 2*a in sizes
pivot O
slider K along y
link OB
link BK
OB = a @ 70 deg
BK = b @ 100 deg
torque M on OB
force F at K along -y
find k = M/F
"""


@pytest.mark.parametrize("brief", [False, True])
def test_what_choices_and_lists_give_is_not_defined_again_without_its_units(brief):
    """``a = 0.05 when v < 2`` is no length, and ``next(2a, 0.08)`` is no formula for people."""
    compilation = Compilation(Source("m.mech", LOOKED_UP))
    (emitted,) = emit(compilation, TARGET, Options("m", brief=brief))
    page = emitted.text.partition(r"\begin{document}")[2].replace("&", "")
    assert "0.05," not in page
    assert "operatorname{next}" not in page
    assert r"a=50\,\text{mm}" in page


@pytest.mark.parametrize("name", ["triad_closed", "double_butterfly"])
def test_loops_that_close_together_stand_one_behind_the_other(name):
    """Each with its equation along x, then that along y; a term with a minus on the other side."""
    (solved,) = (
        group
        for group in grouped(loaded(name).results["k"].where)
        if isinstance(group, SolvedSystem)
    )
    sides = [[text(side) for side in without_minus(zero)] for zero in solved.zeros]
    axes = ["cos" if "cos" in left else "sin" for left, _ in sides]
    assert axes == ["cos", "sin"] * (len(axes) // 2)
    assert all("sin" not in left + right for left, right in sides[::2])
    assert not any(side.startswith("-") or " - a*" in side for pair in sides for side in pair)


def directions(figure, *ends):
    """Return the direction in which each of two points lies seen from the first one."""
    at, *others = (figure.points[point] for point in ends)
    return [math.atan2(other.y - at.y, other.x - at.x) for other in others]


@pytest.mark.parametrize("name", CLOSED)
def test_names_are_what_is_said_of_them(name):
    """Angles of triangles, inclinations and directions, measured in the drawing."""
    compilation = compiled(name)
    known = completed(defaults(compilation.mechanism), compilation.pose.definitions)
    for step in compilation.derivation.position:
        for angle, (first, vertex, last) in step.corners:
            one, other = directions(compilation.figure, vertex, first, last)
            corner = abs(math.remainder(other - one, math.tau))
            assert corner == pytest.approx(known[angle], abs=1e-9)
        known = completed(known, step.definitions)
        own = own_names(compilation.mechanism)
        for found in (d.name for d in step.definitions if d.name not in own):
            if ends := ["".join(point) for point in split_points(direction_of(found))]:
                (measured,) = directions(compilation.figure, *ends)
                off = math.remainder(measured - known[found], math.tau)
                assert off == pytest.approx(0, abs=1e-9)


@pytest.mark.parametrize("along", ["x", "-x"])
@pytest.mark.parametrize("mode", ["forward", "back"])
def test_a_guide_has_one_of_two_places_as_the_text_says(along, mode):
    source = SLIDER.replace("along x through", f"along {along} through")
    source = source.replace("assembly B forward", f"assembly B {mode}")
    compilation = Compilation(Source("m.mech", source))
    (step,) = compilation.derivation.position
    assert (step.pin, step.is_ahead) == ("B", mode == "forward")
    assert step.inclined == ("beta_AB", "AB")
    ahead = (1 if along == "x" else -1) * (1 if mode == "forward" else -1)
    assert compilation.figure.points["B"].x * ahead > 0


@pytest.mark.parametrize(
    ("language", "sentences"),
    [
        (
            "en",
            "β_AB is the inclination of AB to the guide. Of the two possible places of B on the "
            "guide it is the one farther in the direction of the guide.",
        ),
        (
            "uk",
            "β_AB — кут нахилу AB до напрямної. З двох можливих положень точки B на напрямній "
            "вибрано те, що далі в її додатному напрямі.",
        ),
        (
            "ru",
            "β_AB — угол наклона AB к направляющей. Из двух возможных положений точки B на "
            "направляющей выбрано то, что дальше в её положительном направлении.",
        ),
    ],
)
def test_a_slider_is_said_to_be_assembled(language, sentences):
    compilation = Compilation(Source("m.mech", SLIDER))
    spell = speller(compilation.results, compilation.mechanism, True, language)
    (said,) = position_sentences(compilation.derivation.position, locale(language), spell)
    assert said.endswith(sentences)


def test_angles_of_a_triangle_are_introduced():
    compilation = compiled("oscillating_cylinder")
    spell = speller(compilation.results, compilation.mechanism, True)
    (said,) = position_sentences(compilation.derivation.position, locale("en"), spell)
    assert said.endswith("Here μ_B = ∠CBO and γ_C = ∠BCO.")
    page = emit(compilation, TARGET, Options("m"))[0].text
    assert r"$\mu_B=\angle CBO$" in page
    assert r"$\gamma_C=\angle BCO$" in page


SWING = """\
mechanism swing "Lever pushed by a cylinder"
param phi = 40 deg
pivot O at (0 mm, 0 mm)
pivot C at (-300 mm, -80 mm)
link OAB
telescope CA
OA = 150 mm @ phi
OB = 400 mm @ phi
drive phi from 10 deg to 80 deg
{load}
force W at B along -y
find {found}
"""


@pytest.mark.parametrize(
    ("load", "found", "kind"),
    [
        ("actuator P between C and A", "k = P/W", "cylinder"),
        ("spring 5 N/mm between C and A free 300 mm\nforce P at B along x", "P", "telescope"),
    ],
)
def test_a_telescope_has_its_direction_from_the_places_of_its_ends(load, found, kind):
    source = Source("swing.mech", SWING.format(load=load, found=found))
    (step,) = Compilation(source).derivation.position
    assert (step.kind, step.part) == (kind, "CA")
    assert [d.name for d in step.definitions] == ["phi_CA"]
    spell = speller((), compiled("four_bar").pose.mechanism, False, "en")
    (said,) = position_sentences([step], locale("en"), spell)
    assert said.endswith("CA: the places of its ends give its direction.")


def test_a_drawn_cylinder_in_a_loop_is_no_slot_and_its_direction_has_its_name():
    lift = """
    mechanism lift
    pivot A at (0 mm, 0 mm)
    pivot E at (-100 mm, 50 mm)
    link ABG
    telescope EG
    B at (600 mm, -100 mm)
    G at (300 mm, -60 mm)
    drive AB from -20 deg to 40 deg
    actuator S between E and G
    weight W mass 500 kg at B
    find m = S/W
    """
    (step,) = Compilation(Source("lift.mech", lift)).derivation.position
    assert (step.kind, step.part) == ("cylinder", "EG")
    assert [d.name for d in step.definitions] == ["phi_EG"]


EQUAL_NUMBERS = """
param phi = 100 deg in 20 deg .. 160 deg
pivot O at (0 mm, 0 mm)
pivot Q at (44 mm, 0 mm)
link OA
link AB
link QB
OA = 20 mm @ phi
AB = 54 mm
QB = {rocker} mm
assembly ABQ cw
drive phi from 20 deg to 160 deg
torque M on OA
torque T on QB
find k = M/T
"""


@pytest.mark.parametrize(
    ("rocker", "angle"),
    [
        (54, "μ_B = arccos((2 · AB² − AQ²) / (2 · AB²))"),
        (53, "μ_B = arccos((AB² + QB² − AQ²) / (2 · AB · QB))"),
    ],
)
def test_sides_that_are_equal_by_their_numbers_have_the_law_of_cosines_too(rocker, angle):
    compilation = Compilation(Source("m.mech", EQUAL_NUMBERS.format(rocker=rocker)))
    shown = render(compilation.derivation, compilation.mechanism)
    assert angle in shown
    assert "atan2(√" not in shown
