"""A circular slot is called a slot, though a rod stands for it in what is computed."""

import pytest

from mechc.compilation import compile_source
from mechc.report.derivation.forces import of_forces
from mechc.report.kinds import SentenceKind
from mechc.report.languages.registry import LANGUAGES
from mechc.report.text.derivation import render
from mechc.source import Source

LEVER = """
pivot O at (0 mm, 0 mm)
slider B along y
link OAC
A at (140 mm, 40 mm)
C at (40 mm, -60 mm)
B at (70 mm, 35 mm)
slot B in OAC about C radius 100 mm
drive OA from 0 deg to 40 deg
force P at A along -y
force F at B along y
find k = P/F
find N_CB
"""

FRICTION = "friction contact B 0.1\n"


def shown(text, language="en"):
    found = compile_source(Source("slot.mech", text))
    return " ".join(render(found.derivation, found.mechanism, language=language).split())


SAID = {
    "en": [
        "its projection across the guide gives the direction of the radius of the circular slot",
        "Circular slot of OAC: relative to this link the pin B moves along the tangent, so that on "
        "the radius CB the velocities of C and B have equal projections.",
        "Force of the circular slot at B",
        "N_CB is the force of the circular slot of OAC on B, positive towards C.",
    ],
    "ru": [
        "даёт направление радиуса дугового паза",
        "Дуговой паз звена OAC: относительно этого звена палец B движется по касательной к пазу, "
        "поэтому проекции скоростей точек C и B на радиус CB равны.",
        "Реакция дугового паза в точке B",
        "N_CB — сила, с которой дуговой паз звена OAC действует на B, положительная по направлению "
        "к C.",
    ],
    "uk": [
        "дає напрям радіуса дугового паза",
        "Дуговий паз ланки OAC: відносно цієї ланки палець B рухається по дотичній до паза, тому "
        "проєкції швидкостей точок C та B на радіус CB рівні.",
        "Реакція дугового паза в точці B",
        "N_CB — сила, з якою дуговий паз ланки OAC діє на B, додатна за напрямом до C.",
    ],
}
RODS = {"en": "rod", "ru": "стерж", "uk": "стриж"}


@pytest.mark.parametrize("language", LANGUAGES)
def test_there_is_no_rod(language):
    text = shown(LEVER + FRICTION, language)
    assert [said for said in SAID[language] if said not in text] == []
    assert RODS[language] not in text


def test_friction_in_it_turns_about_its_centre():
    text = shown(LEVER + FRICTION)
    assert "In a circular slot the angular velocity Ω of its radius relative to the link" in text
    assert "In a pin" not in text
    assert "In a pin" in shown(LEVER + FRICTION + "friction pin O 0.1 diameter 8 mm\n")


def test_the_slot_gives_way_where_its_force_is_found_by_powers():
    solution = compile_source(Source("slot.mech", LEVER)).solution
    (account,) = of_forces(solution)
    kinds = [paragraph.sentence for paragraph in account.paragraphs]
    assert SentenceKind.CIRCULAR_SLOT_RELEASED in kinds
    assert SentenceKind.PIN not in kinds
