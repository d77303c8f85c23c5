"""Names, numbers and formulas as they are lettered: what each run says, and at which height."""

import pytest

from mechc.base.frozen import replace
from mechc.drawing.from_figure import scheme
from mechc.drawing.lettering import figures, formula, measured, name, text_size, times
from mechc.figure.from_pose import draw
from mechc.report.languages.en.pictured import WORDS as EN
from small_poses import lever


def written(runs):
    """Return text with the level of each run that is not on the line."""
    return "".join(f"{run.text}{{{run.level}}}" if run.level else run.text for run in runs)


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (-0.12345, "−0.123"),
        (1234.5, "1230"),
        (999999.0, "1000000"),
        (1e6, "1e+06"),
        (999.6, "1e+03"),
        (1000.0, "1000"),
        (2.0, "2"),
    ],
)
def test_a_number_has_three_figures(value, text):
    assert figures(value) == text


@pytest.mark.parametrize(
    ("value", "of_another", "text"),
    [
        (1.0, False, " = 1 "),
        (1.0, True, " = "),
        (1.002, False, " = 1 "),
        (1.002, True, " = 1.00 "),
        (1.02, True, " = 1.02 "),
        (2.5e-7, False, " = 2.5 · 10−7{1} "),
        (-2.5e7, True, " = −2.5 · 107{1} "),
    ],
)
def test_one_of_another_quantity_is_not_written(value, of_another, text):
    assert written(measured(value, of_another)).replace("\u2009", " ") == text


@pytest.mark.parametrize(
    ("source", "text"),
    [
        ("alpha_1", "α1{-1}"),
        ("omega_OB1", "ωOB{-1}1{-2}"),
        ("len_AB", "AB"),
        ("R_B_on_AB", "RB{-1}A{1}B{1}"),
        ("M_over_F", "M/F"),
    ],
)
def test_names_have_indices_below_and_links_above(source, text):
    assert written(name(source)) == text


@pytest.mark.parametrize(
    ("source", "text"),
    [
        ("a + b", "a + b"),
        ("-a", "−a"),
        ("2*l_A - 40 mm", "2lA{-1} − 40\u2009mm"),
        ("a^2", "a2{1}"),
        ("(-a)", "(−a)"),
        ("pi*cos(phi)", "π\u2009cos\u2009φ"),
    ],
)
def test_signs_of_sums_stand_between_spaces(source, text):
    assert written(formula(source)) == text


@pytest.mark.parametrize(("count", "text"), [(1.0, "P"), (2.0, "2P"), (0.5, "P/2"), (1.5, "3P/2")])
def test_a_load_is_named_after_how_often_it_acts(count, text):
    assert written(times(count, "P")) == text


def test_indices_take_less_room_and_make_a_line_higher():
    plain, lowered = text_size(name("P"), 4.0), text_size(name("P_1"), 4.0)
    assert plain == pytest.approx((4 * 0.85, 4 * 0.95))
    assert lowered == pytest.approx((4 * (0.85 + 0.7 * 0.56), 4 * 1.15))


@pytest.mark.parametrize(("title", "shown"), [("", "by_hand"), ("A lever", "A lever")])
def test_a_scheme_is_called_by_its_title_or_its_name(title, shown):
    figure = replace(draw(lever()), title=title)
    assert scheme(figure, EN).title == shown
