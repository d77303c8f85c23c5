"""A link that only translates: one step for two, and no angular velocity that is zero after it."""

import pytest

from good_mechanisms import compiled
from mechc.formula.tree import ZERO, Symbol, negative, product, total
from mechc.report.derivation.from_solution import translating
from mechc.report.kinds import StepRule
from mechc.report.languages.registry import locale
from mechc.report.sentences.wording import lines, sentences
from mechc.report.steps import DerivationStep, Equation

V_B, V_C, SPIN, ARM = (Symbol(n) for n in ("V_B", "V_C", "omega_BCJ", "r"))
EQUAL = Equation(V_C, V_B)
PROJECTION = DerivationStep(StepRule.PROJECTION, ("B", "C"), (EQUAL,), (EQUAL,))
AT_REST = DerivationStep(
    StepRule.ROTATION,
    ("BCJ", "C", "B"),
    (Equation(product([(ARM, 1), (SPIN, 1)]), total([V_C, negative(V_B)])),),
    (Equation(SPIN, ZERO),),
)
SAID = Equation(Symbol("V_J_F"), total([V_B, product([(ARM, 1), (SPIN, 1)])]))
ALONG = DerivationStep(
    StepRule.COMPONENT_OF_BODY, ("BCJ", "B", "J", "F"), (SAID,), (Equation(SAID.left, V_B),)
)


def test_one_step_says_that_a_link_translates():
    found = translating([PROJECTION, AT_REST, ALONG])
    assert [step.rule for step in found] == [
        StepRule.TRANSLATION,
        StepRule.COMPONENT_OF_TRANSLATION,
    ]
    assert found[0].subject == ("BCJ", "C", "B")
    assert found[0].results == (EQUAL, Equation(SPIN, ZERO))
    assert found[1].relations == (Equation(SAID.left, V_B),)
    said, hence = lines(found[0])
    assert (said, hence) == (((V_C, V_B), (SPIN, ZERO)), ())


@pytest.mark.parametrize(
    "steps",
    [
        [PROJECTION, ALONG],
        [
            PROJECTION,
            DerivationStep(StepRule.ROTATION, AT_REST.subject, (), (Equation(SPIN, V_B),)),
            ALONG,
        ],
    ],
)
def test_what_is_not_of_two_equal_velocities_stays(steps):
    assert translating(steps) == tuple(steps)


ALONE = DerivationStep(StepRule.ROTATION, AT_REST.subject, AT_REST.relations, AT_REST.results)
AWAY = DerivationStep(StepRule.ROTATION, AT_REST.subject, (Equation(SPIN, ZERO),), AT_REST.results)


@pytest.mark.parametrize(
    ("step", "guided", "rule", "said"),
    [
        (ALONE, "", StepRule.EQUAL_VELOCITIES, (EQUAL, Equation(SPIN, ZERO))),
        (AWAY, "", StepRule.EQUAL_VELOCITIES, (Equation(SPIN, ZERO),)),
        (AWAY, "C", StepRule.EQUAL_VELOCITIES, (Equation(SPIN, ZERO),)),
        (ALONE, "BC", StepRule.PARALLEL_GUIDES, (Equation(SPIN, ZERO),)),
    ],
)
def test_a_link_whose_velocities_are_known_to_be_equal_translates(step, guided, rule, said):
    found = translating([step, ALONG], frozenset(guided))
    assert [each.rule for each in found] == [rule, StepRule.COMPONENT_OF_TRANSLATION]
    assert found[0].relations == said
    assert found[0].results == (Equation(SPIN, ZERO),)
    assert found[1].relations == (Equation(SAID.left, V_B),)


PARALLEL = {
    "en": "The guides of A and B are parallel: the link ABCG translates.",
    "uk": "Напрямні точок A та B паралельні: ланка ABCG рухається поступально.",
    "ru": "Направляющие точек A и B параллельны: звено ABCG движется поступательно.",
}
EQUAL_ENDS = {
    "en": "The velocities of B and D are equal: the link BDH translates.",
    "uk": "Швидкості точок B та D рівні: ланка BDH рухається поступально.",
    "ru": "Скорости точек B и D равны: звено BDH движется поступательно.",
}


@pytest.mark.parametrize("language", PARALLEL)
@pytest.mark.parametrize(
    ("name", "expected"), [("cabinet_on_casters", PARALLEL), ("roberval_balance", EQUAL_ENDS)]
)
def test_it_is_said_that_guides_are_parallel_or_velocities_equal(name, expected, language):
    steps = compiled(name).derivation.steps
    assert expected[language] in sentences(steps, locale(language), lambda point: point)


SENTENCES = {
    "en": "The velocities of B and C are parallel, and their projections on the line between these "
    "points are equal: the link BCJ translates.",
    "uk": "Швидкості точок B та C паралельні, а їхні проєкції на пряму, що з’єднує ці точки, рівні:"
    " ланка BCJ рухається поступально.",
    "ru": "Скорости точек B и C параллельны, а их проекции на прямую, соединяющую эти точки, равны:"
    " звено BCJ движется поступательно.",
}


@pytest.mark.parametrize("language", SENTENCES)
def test_it_is_said_why_a_link_translates(language):
    steps = compiled("d45_14_parallelogram_jaw").derivation.steps
    said = list(sentences(steps, locale(language), lambda name: name))
    assert SENTENCES[language] in said
    assert [step.rule for step in steps].count(StepRule.ROTATION) == 0


@pytest.mark.parametrize("name", ["parallel_gripper", "roberval_balance"])
def test_no_step_has_an_angular_velocity_that_was_left_out(name):
    """What still has one follows the step that gives it."""
    known = set()
    for step in compiled(name).derivation.steps:
        known |= {str(e.left) for e in step.results} | {str(e.left) for e in step.relations}
        text = str([e.right for e in (*step.relations, *step.results)])
        for spin in ("omega_ACJ", "omega_ACG", "omega_BDH"):
            assert spin not in text or str(Symbol(spin)) in known
