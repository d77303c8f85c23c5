"""The component of a point's velocity along a load has its reason, and is true to it."""

import pytest

from good_mechanisms import ALL, compiled
from mechc.formula.to_text import text
from mechc.report.kinds import StepRule
from mechc.report.languages.registry import LANGUAGES, locale
from mechc.report.sentences.wording import sentences

KINDS = {
    "claw_closed": (StepRule.COMPONENT_OF_ROTATION, ("O", "C", "R")),
    "bolt_cutter": (StepRule.COMPONENT_OF_BODY, ("HGE", "H", "E", "P")),
    "peaucellier": (StepRule.COMPONENT_OF_TWO, ("Q", "F")),
}


def steps(name):
    return compiled(name).derivation.steps


@pytest.mark.parametrize("name", KINDS)
def test_a_component_follows_from_what_its_velocity_is_made_of(name):
    rule, subject = KINDS[name]
    assert [s.subject for s in steps(name) if s.rule is rule][:1] == [subject]


@pytest.mark.parametrize(
    ("name", "moved"), [("jansen_leg", [("DEF", "D", "E")]), ("crank_rocker", [])]
)
def test_what_a_velocity_is_made_of_is_said_with_the_projection_that_takes_it(name, moved):
    """That of E is V_D with the rotation of DEF; of a four-bar both ends turn about pivots."""
    said = [
        (step, of) for step in steps(name) for rule, of in step.reasons if rule is StepRule.PLANE
    ]
    assert [subject for _, subject in said] == moved
    for step, subject in said:
        assert step.rule is StepRule.PROJECTION
        assert subject[-1] in step.subject


@pytest.mark.parametrize("name", ["jansen_leg", "scissor_4", "bolt_cutter", "watt_closed"])
def test_no_step_is_a_bare_sentence(name):
    assert all(step.relations for step in steps(name))


@pytest.mark.parametrize("language", LANGUAGES)
def test_plane_motion_is_explained_in_full_once(language):
    """Of C2 in full, of B2 and what follows in short."""
    of = locale(language)
    said = " ".join(sentences(steps("scissor_4"), of, lambda name: name))
    names = {"first": "A1C2B2", "second": "A1"}
    assert said.count(of.rules["plane"].format(last="C2", **names)) == 1
    assert said.count(of.again["plane"].format(last="B2", **names)) == 1


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("name", KINDS)
def test_the_reason_names_all_that_it_rests_on(name, language):
    rule, subject = KINDS[name]
    said = sentences(steps(name), locale(language), lambda name: f"<{name}>")
    found = next(s for step, s in zip(steps(name), said, strict=True) if step.rule is rule)
    assert {part for part in subject if f"<{part}>" in found} == {*subject}


@pytest.mark.parametrize("name", ["scissor_2", "cabinet_on_casters", "roberval_balance"])
def test_other_bodies_have_theirs(name):
    assert not [s for s in steps(name) if s.rule is StepRule.COMPONENT]


@pytest.mark.slow
def test_no_component_of_the_library_is_without_a_reason():
    assert not [name for name in ALL for s in steps(name) if s.rule is StepRule.COMPONENT]


def test_the_component_of_a_point_is_by_the_speed_of_the_pole_that_a_step_has_named():
    (step,) = (s for s in steps("hoeken") if s.rule is StepRule.COMPONENT_OF_BODY)
    (component,) = step.relations
    assert text(component.right) == "sin(phi)*V_A + 5*a*sin(phi_AB)*omega_ABP"
