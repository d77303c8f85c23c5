"""Sentences as a native writes them: what a minus means, which way a vector is turned."""

import pytest

import mechc
from good_mechanisms import loaded
from mechc.base.frozen import replace
from mechc.report.latex.notation import notation, translated


def page(name: str, language: str = "en") -> str:
    return loaded(name).emit("latex", language=language)


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", r"in the direction of $\overrightarrow{BO_{2}}$ turned by $+90^\circ$."),
        ("uk", r"у напрямі вектора $\overrightarrow{BO_{2}}$, повернутого на $+90^\circ$."),
        ("ru", r"в направлении вектора $\overrightarrow{BO_{2}}$, повёрнутого на $+90^\circ$."),
    ],
)
def test_of_two_perpendicular_directions_one_is_said(language, said):
    assert said in page("crank_rocker", language)


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", "The minus of $k$ means: at the values given $M$ acts against its arrow while $T$"),
        ("uk", "момент $M$ діє проти своєї стрілки, тоді як момент $T$ — за своєю."),
        ("ru", "момент $M$ действует против своей стрелки, тогда как момент $T$ — по своей."),
    ],
)
def test_a_minus_says_which_load_acts_against_its_arrow(language, said):
    assert said in page("planetary_gear", language)


def test_so_does_that_of_a_load_with_friction_alone():
    text = page("plate_clutch")
    assert r"The minus of $M_{\mathrm{hold}}$ means: at the values given $M$ acts against" in text
    assert text.count("The minus of") == 1
    assert "The minus of" not in page("crank_rocker")


def test_what_is_inversely_proportional_is_called_so():
    assert "$k$ is inversely proportional to $a$." in page("shoe_brake")
    assert "змінюється обернено пропорційно $l_A$." in page("three_claw_gripper", "uk")
    assert r"is proportional to $\frac{b}{a}$." in page("bell_crank")


def test_what_a_result_does_not_depend_on_is_joined_by_or():
    assert r"$k$ does not depend on $m$ or $\varphi$." in page("planetary_gear")
    assert r"$k$ не залежить від $m$ та $\varphi$." in page("planetary_gear", "uk")


def test_a_body_of_two_points_is_its_slot():
    assert "The pin $B$ slides along $XY$." in page("scotch_yoke")
    assert "The pin $B$ slides along the line $QC$ of $QCD$." in page("whitworth")


def test_a_screw_moves_by_its_lead():
    text = page("screw_jack_with_collar")  # its thread is double: the lead is 2p
    assert "The screw moves $A$ by its lead in each turn." in text
    assert r"V_A=\frac{p\omega_{OE}}{\pi}" in text


def test_no_difference_at_all_is_said_as_a_bound():
    assert "(largest relative difference ${<}10^{-16}$)" in page("plate_clutch")


def test_zero_degrees_have_their_sign():
    assert r"$0^\circ\leq \varphi\leq 360^\circ$" in page("crank_rocker")


def test_names_of_the_picture_in_texts_stand_as_in_formulas():
    text = page("four_bar")
    assert "crank $O_{1}A$" in text
    assert "rocker's arm $O_{2}C$ of the load" in text


def test_words_of_letters_that_are_no_points_stay():
    style = replace(notation("en"), pictured=frozenset("ABC"))
    assert translated("A lever AB, an AC motor, DIN 5", style) == (
        "A lever $AB$, an $AC$ motor, DIN 5"
    )
    assert translated("bore d of ABD", style) == "bore d of ABD"


def test_letters_have_one_shape_on_a_page():
    text = loaded("crank_rocker").emit("latex", pictures=True)
    assert r"\phi" not in text
    assert r"\varphi" in text


def test_two_types_in_an_index_are_one_index():
    text = loaded("crank_rocker").emit("latex", pictures=True)
    assert r"\mathit{R}_{\mathit{O}_{1}}" in text
    assert "}_{1}_{" not in text


def test_a_single_letter_is_a_word_in_english_alone():
    points = frozenset("ABC")
    said = [translated("A B", replace(notation(lang), pictured=points)) for lang in ("en", "uk")]
    assert said == ["A $B$", "$A$ $B$"]


def test_words_in_an_index_are_as_small_as_it_is():
    text = loaded("block_and_tackle").emit("latex", language="uk", pictures=True)
    assert r"\text{\mechccyr{с}}" in text
    assert r"\mbox{\mechccyr" not in text


def test_the_value_of_a_choice_is_apart_from_its_cases():
    text = loaded("jaw_sizes").emit("latex")
    assert text.count(r"\end{cases}=") == 0
    assert r"\end{cases}\qquad D=10\,\text{mm} \]" in text


def test_a_velocity_along_a_guide_against_its_load_says_what_it_counts_along():
    """Steps count V_B along F, which acts against the guide; the ratio counts it along that."""
    whole = mechc.loads(
        "pivot O at (0 mm, 0 mm)\nlink OA\nlink AB\nslider B along x through (0 mm, 0 mm)\n"
        "A at (20 mm, 40 mm)\nB at (150 mm, 0 mm)\ndrive OA from 0 deg to 360 deg\n"
        "torque M on OA\nforce F at B along -x\nfind k = M/F\nfind V_B/omega_OA\n"
    )
    text = " ".join(whole.emit("latex").split())
    assert text.count("Velocities are positive along their guides here, angular ones") == 1
