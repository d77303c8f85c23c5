"""What explains the power equation: factors of loads, projections of velocities."""

import pytest

from mechc.base.frozen import replace
from mechc.compilation import Compilation, emit
from mechc.emit.latex.to_latex import TARGET
from mechc.emit.target import Options
from mechc.formula.tree import number
from mechc.report.languages.registry import locale
from mechc.report.sentences.powers import power_remarks
from mechc.report.text.speller import speller
from mechc.source import Source

LEVER = """
param a = 100 mm
param b = 60 mm
param alpha = 20 deg
pivot O
link OAB
OA = a @ alpha
OB = b @ 0 deg
force P at A along {way}
force F at B along y {times}
{whole}
find k = P/F
"""


def lever(way="perp OA", times="", whole=""):
    return Compilation(Source("m.mech", LEVER.format(way=way, times=times, whole=whole)))


def said(language="en", **how):
    compilation = lever(**how)
    spell = speller(compilation.results, compilation.mechanism, True, language)
    return power_remarks(compilation.derivation, compilation.mechanism, locale(language), spell)


def test_of_forces_along_velocities_that_act_once_nothing_is_said():
    assert said() == ""


@pytest.mark.parametrize(
    ("language", "sentence"),
    [
        (
            "en",
            "In the power of a force the velocity of its point counts by its projection on the "
            "line of action: V_A · cos α for P.",
        ),
        (
            "uk",
            "Потужність сили визначає проєкція швидкості точки на лінію дії сили: "
            "V_A · cos α для P.",
        ),
        (
            "ru",
            "Мощность силы определяется проекцией скорости точки на линию действия силы: "
            "V_A · cos α для P.",
        ),
    ],
)
def test_the_cosine_is_of_the_angle_between_a_force_and_a_velocity(language, sentence):
    assert said(language, way="y") == sentence


def test_a_projection_has_no_minus():
    """That is in the equation: the load works against the motion."""
    source = LEVER.replace("F at B along y", "F at B along alpha + 40 deg")
    against = Compilation(Source("m.mech", source.format(way="-y", times="", whole="")))
    spell = speller(against.results, against.mechanism, True)
    (balance,) = against.derivation.balances
    assert "− F · V_B · sin(α + 40°)" in spell.relation((balance.left,), (), False)
    found = power_remarks(against.derivation, against.mechanism, locale("en"), spell)
    assert found.endswith("line of action: V_A · cos α for P and V_B · sin(α + 40°) for F.")


def test_a_projection_is_written_as_in_the_equation():
    """In the equation the sine is turned round: V_A · sin(φ_OA − 30°) stood above it."""
    drawn = Compilation(
        Source(
            "m.mech",
            "pivot O at (0 mm, 0 mm)\nlink OA\nA at (20 mm, -15 mm)\n"
            "torque P on OA\nforce F at A along 30 deg\nfind k = P/F",
        )
    )
    spell = speller(drawn.results, drawn.mechanism, True)
    found = power_remarks(drawn.derivation, drawn.mechanism, locale("en"), spell)
    (balance,) = drawn.derivation.balances
    assert "F · V_A · sin(30° − φ_OA)" in spell.relation((balance.left,), (), False)
    assert found.endswith("line of action: V_A · sin(30° − φ_OA) for F.")


MIRROR = "mirror across y sharing O"
COPIES = "copies 3 sharing O"


@pytest.mark.parametrize(
    ("whole", "sentence"),
    [
        (MIRROR, "The factor 2 of P and F: such a load acts in both mirrored halves."),
        (COPIES, "The factor 3 of P and F: such a load acts in each of the 3 equal parts."),
    ],
)
def test_a_factor_counts_equal_parts(whole, sentence):
    assert said(whole=whole) == sentence


def test_a_factor_that_is_written_with_the_load_is_not_explained():
    assert said(times="times 2") == ""
    assert said(times="times 2", whole=MIRROR).startswith("The factor 2 of P: such a load")


def test_of_several_equations_it_is_said_why():
    compilation = lever("y")
    derivation, mechanism = compilation.derivation, compilation.mechanism
    spell = speller(compilation.results, mechanism, True)
    twice = replace(derivation, balances=derivation.balances * 2)
    assert power_remarks(twice, mechanism, locale("en"), spell) == (
        "The mechanism has 2 degrees of freedom, hence 2 equations."
    )
    none = replace(derivation, balances=(), terms=(replace(derivation.terms[0], times=number(2)),))
    assert power_remarks(none, mechanism, locale("en"), spell) == ""


def test_pages_have_the_sentence_too():
    compilation = lever("y", whole=MIRROR)
    page = emit(compilation, TARGET, Options("m"))[0].text
    assert "such a load acts in both mirrored halves. In the power of a force" in page


def test_a_cylinder_on_a_pivot_works_along_the_velocity_of_its_other_end():
    swing = """
    param phi = 40 deg
    pivot O at (0 mm, 0 mm)
    pivot C at (-300 mm, -80 mm)
    link OAB
    telescope CA
    OA = 150 mm @ phi
    OB = 400 mm @ phi
    drive phi from 20 deg to 80 deg
    actuator P between C and A
    force W at B along -y
    find k = P/W
    """
    found = Compilation(Source("swing.mech", swing))
    spell = speller((), found.mechanism, True, "en")
    said = power_remarks(found.derivation, found.mechanism, locale("en"), spell)
    assert said.endswith("line of action: V_A · sin(φ − φ_CA) for P and V_B · cos φ for W.")
