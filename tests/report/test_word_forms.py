"""Words of a report agree with what they are about: one or several, a point or a body, wheels."""

import pytest

import mechc
from good_mechanisms import loaded
from small_mechanisms import vice

DRUM = """
mechanism drum
pivot O at (0 mm, 0 mm)
slider K along y
link OC
OC = 300 mm @ 0 deg
rack K on O 80 mm
force P at C along -y
force Q at K along -y
find k = P/Q
"""

BELT = """
mechanism belt
pivot O1 at (0 mm, 0 mm)
pivot O2 at (400 mm, 0 mm)
link O1A
link O2B
O1A = 40 mm @ 0 deg
O2B = 90 mm @ 180 deg
belt O1 60 mm, O2 180 mm
torque M on O1A
force Q at B along -y
friction belt O1 0.04
find k = M/Q
find omega_O2B/omega_O1A
find V_A/omega_O2B
"""

WEDGE = """
mechanism wedge
slide WX along x
slide YZ along y
contact Y on WX normal 100 deg
force P at W along -x
force Q at Y along -y
friction slider W 0.1
find k = P/Q
"""


def page(description: str, language: str) -> str:
    return mechc.loads(description).emit("latex", language=language)


@pytest.mark.parametrize(
    ("language", "one", "several"),
    [
        ("en", ["Rigid link: $OC$."], ["Rigid links: $O_{1}A$ and $O_{2}B$."]),
        (
            "uk",
            ["Нерухомий шарнір: $O$.", "Жорстка ланка: $OC$."],
            ["Нерухомі шарніри: $O_{1}$ та $O_{2}$.", "Жорсткі ланки: $O_{1}A$ та $O_{2}B$."],
        ),
        (
            "ru",
            ["Неподвижный шарнир: $O$.", "Жёсткое звено: $OC$."],
            ["Неподвижные шарниры: $O_{1}$ и $O_{2}$.", "Жёсткие звенья: $O_{1}A$ и $O_{2}B$."],
        ),
    ],
)
def test_one_item_is_in_the_singular(language, one, several):
    for description, sentences in ((DRUM, one), (BELT, several)):
        shown = page(description, language)
        assert [said for said in sentences if said not in shown] == []


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("uk", "описано одну половину, спільна точка: $K$."),
        ("ru", "описана одна половина, общая точка: $K$."),
    ],
)
def test_one_shared_point_is_in_the_singular(language: str, said: str) -> None:
    assert said in loaded("karpenko_fig9_with_friction").emit("latex", language=language)


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", ["Transmission ratio", "Velocity ratio", "radius of the pulley on $O_{1}$"]),
        ("uk", ["Передавальне відношення", "Відношення швидкостей", "Пас не ковзає по шківах"]),
        ("ru", ["Передаточное отношение", "Отношение скоростей", "не проскальзывает по шкивам"]),
    ],
)
def test_two_wheels_have_a_transmission_ratio_and_those_of_a_belt_are_pulleys(
    language: str, said: list[str]
) -> None:
    shown = page(BELT, language)
    assert [words for words in said if words not in shown] == []


def test_a_part_of_the_force_that_wheels_pass_on_is_lost() -> None:
    assert "a fraction $f_{O_{1}}$ of the transmitted force is lost." in page(BELT, "en")


@pytest.mark.parametrize(
    ("language", "of_body", "of_point"),
    [("uk", "рівноваги тіла $", "рівноваги повзуна $K$"), ("ru", "тела $", "ползуна $K$")],
)
def test_a_body_that_translates_is_no_slider(language: str, of_body: str, of_point: str) -> None:
    assert of_body in page(WEDGE, language)
    shown = loaded("karpenko_fig9_with_friction").emit("latex", language=language)
    assert of_point in shown
    assert of_body not in shown


def test_what_was_not_compared_everywhere_is_said_in_sentences() -> None:
    lines = [
        line
        for line in page(vice("find F", "find n = F/P"), "en").splitlines()
        if " poses: " in line
    ]
    assert [line[-1] for line in lines] == [".", "."]
