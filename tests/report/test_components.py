"""The component of a point's velocity along a load has its reason, and is true to it."""

from itertools import pairwise

import pytest

from good_mechanisms import ALL, compiled
from mechc.formula.to_text import text
from mechc.report.kinds import Rule
from mechc.report.languages.registry import LANGUAGES, locale
from mechc.report.sentences.wording import sentences

KINDS = {
    "claw_closed": (Rule.COMPONENT_OF_ROTATION, ("O", "C", "R")),
    "bolt_cutter": (Rule.COMPONENT_OF_BODY, ("HGE", "H", "E", "P")),
    "peaucellier": (Rule.COMPONENT_OF_TWO, ("Q", "F")),
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
def test_what_a_velocity_is_made_of_stands_before_the_projection_that_takes_it(name, moved):
    """That of E is V_D with the rotation of DEF; of a four-bar both ends turn about pivots."""
    found = steps(name)
    assert [s.subject for s in found if s.rule is Rule.PLANE] == moved
    for before, step in pairwise(found):
        if before.rule is Rule.PLANE:
            assert step.rule is Rule.PROJECTION
            assert before.subject[-1] in step.subject


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("name", KINDS)
def test_the_reason_names_all_that_it_rests_on(name, language):
    rule, subject = KINDS[name]
    said = sentences(steps(name), locale(language), lambda name: f"<{name}>")
    found = next(s for step, s in zip(steps(name), said, strict=True) if step.rule is rule)
    assert {part for part in subject if f"<{part}>" in found} == {*subject}


@pytest.mark.parametrize("name", ["scissor_2", "cabinet_on_casters", "roberval_balance"])
def test_other_bodies_have_theirs(name):
    assert not [s for s in steps(name) if s.rule is Rule.COMPONENT]


@pytest.mark.slow
def test_no_component_of_the_library_is_without_a_reason():
    assert not [name for name in ALL for s in steps(name) if s.rule is Rule.COMPONENT]


def test_the_component_of_a_point_is_by_the_speed_of_the_pole_that_a_step_has_named():
    (step,) = (s for s in steps("hoeken") if s.rule is Rule.COMPONENT_OF_BODY)
    (component,) = step.relations
    assert text(component.right) == "sin(phi)*V_A + 5*a*sin(phi_AB)*omega_ABP"
