"""Formulas, names and texts as LaTeX."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from mechc.base.frozen import replace
from mechc.formula.tree import (
    Call,
    Constant,
    Power,
    Product,
    Symbol,
    negative,
    number,
    product,
    total,
)
from mechc.report.latex.display import LINE_WIDTH, DisplayLine, display
from mechc.report.latex.notation import name, notation, points, spellings
from mechc.report.latex.printer import Boxes, box, latex, plain
from mechc.report.latex.text import escape
from report_samples import LONG, formula

EN, UK, RU = (notation(language) for language in ("en", "uk", "ru"))
ANGLES = replace(EN, angles=frozenset({"beta"}))


def test_an_angle_of_zero_is_one_in_a_cosine() -> None:
    assert latex(Call("cos", (number(0),)), EN) == r"\cos0^\circ"


TABLE_1 = {
    "2*b/a*cot(alpha)": r"\frac{2b}{a}\cot\alpha",
    "2*b/a*cos(alpha)*sin(theta)/cos(alpha+theta)": (
        r"\frac{2b}{a}\cdot\frac{\cos\alpha\sin\theta}{\cos(\alpha+\theta)}"
    ),
    "b*cos(alpha)/(a*cos(theta))": r"\frac{b}{a}\cdot\frac{\cos\alpha}{\cos\theta}",
    "1/(2*sin(alpha))": r"\frac{1}{2\sin\alpha}",
    "V_A*sin(theta)/cos(alpha+theta)": r"V_A\,\frac{\sin\theta}{\cos(\alpha+\theta)}",
    "a*sin(alpha+beta)/(2*b*cos(alpha)*cos(beta))": (
        r"\frac{a}{2b}\cdot\frac{\sin(\alpha+\beta)}{\cos\alpha\cos\beta}"
    ),
}
"""What a textbook prints for the ratios of lever clamps, by the formula."""

PIECES = {
    "sin(alpha)**2": r"\sin^{2}\alpha",
    "sin(2*alpha)": r"\sin2\alpha",
    "cos(alpha/2)": r"\cos\left(\frac{\alpha}{2}\right)",
    "cos(deg(40))": r"\cos40^\circ",
    "cos(-alpha)": r"\cos(-\alpha)",
    "sin(alpha - deg(90))": r"\sin(\alpha-90^\circ)",
    "sin(alpha)*a": r"a\sin\alpha",
    "sin(alpha)*V_B*(b + c)/a": r"\frac{V_B(b+c)}{a}\sin\alpha",
    "(a + b)*cos(alpha)": r"(a+b)\cos\alpha",
    "b*sqrt(2*(5 + a)/9)": r"b\frac{\sqrt{2(5+a)}}{3}",
    "sqrt(a/8)": r"\sqrt{\frac{a}{8}}",
    "a - (b - c)": "a-b+c",
    "a*(-2)*b + c": "-2ab+c",
    "c - 2*a*b": "c-2ab",
    "sqrt(a**2 + b**2)": r"\sqrt{a^{2}+b^{2}}",
    "hypot(a, b)": r"\sqrt{a^{2}+b^{2}}",
    "(a + b)**2": "(a+b)^{2}",
    "a**(-2)": r"\frac{1}{a^{2}}",
    "pi*d**2/4": r"\frac{\pi d^{2}}{4}",
    "0.35*a": r"0.35\,a",
    "a/4": r"\frac{a}{4}",
    "abs(a)": r"\left|a\right|",
    "atan2(a, b)": r"\operatorname{atan2}(a,b)",
    "asin(a/b)": r"\arcsin\left(\frac{a}{b}\right)",
    "exp(mu*alpha)": r"\mathrm{e}^{\mu\alpha}",
    "exp(-3*pi*mu/2)": r"\mathrm{e}^{-3\pi\mu/2}",
    "exp(mu*(a + b)/(2*b))": r"\mathrm{e}^{\mu(a+b)/(2b)}",
    "a*len_QD*b": r"a\cdot QD\cdot b",
    "2*len_AB*len_CD**2": r"2AB\cdot CD^{2}",
    "len_OA*exp(mu)*sin(alpha)": r"OA\cdot \mathrm{e}^{\mu}\,\sin\alpha",
}


@pytest.mark.parametrize(("source", "expected"), [*TABLE_1.items(), *PIECES.items()])
def test_formula_is_set_as_a_textbook_sets_it(source: str, expected: str) -> None:
    assert latex(formula(source), EN) == expected


def test_eastern_books_write_tg_and_a_decimal_comma() -> None:
    source = formula("0.35*tan(phi) + cot(phi)")
    assert latex(source, EN) == r"0.35\,\tan\varphi+\cot\varphi"
    for style in (UK, RU):
        expected = r"0{,}35\,\operatorname{tg}\varphi+\operatorname{ctg}\varphi"
        assert latex(source, style) == expected


def test_constants_are_in_degrees_where_the_sum_is_an_angle() -> None:
    assert latex(formula("deg(180) - beta"), ANGLES) == r"180^\circ-\beta"
    assert latex(formula("pi - b"), ANGLES) == r"\pi-b"
    assert latex(formula("r*pi/2"), ANGLES) == r"\frac{\pi r}{2}"


@pytest.mark.parametrize(
    ("symbol", "expected"),
    [
        ("V_A", "V_A"),
        ("V_O1", "V_{O_{1}}"),
        ("V_K'", "V_{K'}"),
        ("omega_OBA", r"\omega_{OBA}"),
        ("alpha_1", r"\alpha_1"),
        ("l12", "l_{12}"),
        ("l_max", r"l_{\mathrm{max}}"),
        ("a_b_c", "a_{b,c}"),
        ("lambda", r"\lambda"),
        ("epsilon", r"\varepsilon"),
        ("input", r"\mathrm{input}"),
        ("phi_AB", r"\varphi_{AB}"),
        ("len_AB", "AB"),
    ],
)
def test_names(symbol: str, expected: str) -> None:
    assert name(symbol, EN) == expected


def test_points() -> None:
    assert points("O1B2K'") == "O_{1}B_{2}K'"


def test_two_names_never_print_alike() -> None:
    names = ["alpha1", "alpha_1", "a", "b"]
    style = replace(EN, spellings=spellings(names, EN))
    assert len({name(n, style) for n in names}) == len(names)


def test_nothing_of_a_text_is_read_by_tex() -> None:
    nasty = r"50% of A&B_{x} #1 \input{/etc/passwd} ~^$"
    assert escape(nasty) == (
        r"50\% of A\&B\_\{x\} \#1 \textbackslash{}input\{/etc/passwd\} "
        r"\textasciitilde{}\textasciicircum{}\$"
    )


@given(st.text(max_size=60))
def test_text_has_no_special_character_left(text: str) -> None:
    escaped = escape(text)
    assert "\n" not in escaped
    assert not set(escaped.replace(r"\%", "").replace(r"\#", "")) & {"%", "#"}
    assert escaped.replace(r"\{", "").count("{") == escaped.replace(r"\}", "").count("}")


def test_long_words_may_break_and_ligatures_do_not_form() -> None:
    assert r"\allowbreak" in escape("x" * 30)
    assert escape("a--b") == r"a-\kern0pt{}-b"


def test_cyrillic_is_marked_and_strange_characters_named() -> None:
    assert escape("Кран λ") == r"\mechccyr{Кран} \ensuremath{\lambda}"
    assert escape("中") == r"\mechcchar{4E2D}{中}{[U+4E2D]}"


SPELLED = {
    "Ħal": r"\mechcchar{0126}{Ħ}{\mechcbarred{H}}al",
    "łódź": "łódź",
    "ấ": r"\mechcchar{1EA5}{ấ}{\'{\^{a}}}",
    "Ợ": r"\mechcchar{1EE2}{Ợ}{\d{O}\kern-0.1em\raisebox{0.2ex}{\textquoteright}}",
    "q\u0303": r"\mechcchar{0071}{q" + "\u0303" + r"}{\~{q}}",
    "а\u0301": r"\mechcchar{0430}{а" + "\u0301" + r"}{\mechccyr{\'{а}}}",
    "Ə": r"\mechcchar{018F}{Ə}{\mechccyr{Ә}}",
    "ή": r"\mechcchar{03AE}{ή}{\ensuremath{\acute{\eta}}}",
    "⁻": r"\mechcchar{207B}{⁻}{\ensuremath{{}^{-}}}",
    "⅓": r"\mechcchar{2153}{⅓}{1/3}",
    "Қазақ": r"\mechccyr{Қазақ}",
}


@pytest.mark.parametrize("letters", SPELLED)
def test_letters_that_no_western_font_has_are_spelled(letters: str) -> None:
    assert escape(letters) == SPELLED[letters]


def widths(shown: str) -> list[float]:
    rows = shown.replace("\\\\", "\n").splitlines()
    return [plain(r.replace("&", "")).width for r in rows if "frac" not in r]


def test_a_short_equation_takes_one_line() -> None:
    shown = display((DisplayLine(plain("k"), formula("a/b")),), notation("en"), "where")
    assert shown == "\\[\nk=\\frac{a}{b}\n\\]"


def test_a_long_sum_is_broken_between_terms() -> None:
    terms = " + ".join(f"l_{i}*V_{'ABCDEFGHKMNQ'[i]}*mu" for i in range(12))
    shown = display((DisplayLine(plain("k"), formula(terms)),), notation("en"), "where")
    assert shown.count("\\\\") >= 1
    assert max(widths(shown)) <= LINE_WIDTH


def test_no_sign_stands_behind_a_sign_of_multiplication() -> None:
    factors = [formula(f"sin(l_{c}*m_{c} + alpha)") for c in "ABCDEFGHKMNPQRS"]
    below = Power(negative(Symbol("z")), number(-1))
    shown = display((DisplayLine(plain("k"), Product((*factors, below))),), EN, "where")
    assert r"\times" in shown
    assert r"\times -" not in shown
    assert shown.startswith("\\begin{align*}\nk&=-")


def test_the_sign_of_a_value_is_printed_without_its_size() -> None:
    sense = Call("sense", (Symbol("a"), Symbol("b")))
    assert latex(sense, EN) == r"\operatorname{sgn}a"


def test_sums_in_a_long_fraction_get_names() -> None:
    shown = display(
        (DisplayLine(plain("k"), formula(f"a*({LONG})/({LONG}+b)")),), notation("en"), "where"
    )
    assert r"\frac{aZ_1}{Z_2}" in shown
    assert shown.count("where") == 1
    assert "Z_1&=" in shown


def test_made_up_names_avoid_those_in_use() -> None:
    shown = display(
        (DisplayLine(plain("k"), formula(f"Z_1*({LONG})/({LONG}+b)")),), notation("en"), "where"
    )
    assert "Z_3&=" in shown
    assert "Z_1&=" not in shown


def test_a_made_up_name_has_one_meaning_in_a_document() -> None:
    style = notation("en")
    first = display((DisplayLine(plain("k"), formula(f"a*({LONG})/({LONG}+b)")),), style, "where")
    other = display((DisplayLine(plain("m"), formula(f"c*({LONG}+d)/({LONG})")),), style, "where")
    assert r"\frac{aZ_1}{Z_2}" in first
    assert r"\frac{cZ_3}{Z_1}" in other
    assert ("Z_3&=" in other, "Z_1&=" in other) == (True, False)


def test_a_number_below_zero_stands_in_brackets_behind_a_function() -> None:
    below = Constant("-0.5", number(-1))
    assert latex(Call("sign", (below,)), EN) == r"\operatorname{sgn}(-0.5)"
    assert latex(Call("sin", (Symbol("alpha"),)), EN) == r"\sin\alpha"


def test_boxes_of_formulas_with_parts_in_common_set_each_part_once(monkeypatch):
    names = []
    inner = total([Symbol("a"), Call("sin", (Symbol("alpha"),))])
    formulas = [product([(inner, 1), (Symbol("b"), n)]) for n in (1, 2, -1)]
    expected = [box(one, EN) for one in formulas]
    plainly = Boxes.name
    monkeypatch.setattr(Boxes, "name", lambda self, name: names.append(name) or plainly(self, name))
    boxes = Boxes(EN)
    assert [boxes.whole(one) for one in formulas] == expected
    assert names.count("a") == names.count("alpha") == 1


def test_a_velocity_is_behind_the_lengths_of_its_row():
    """b V_A, not V_A b; a load stays before it."""
    b, load, speed, spin = map(Symbol, ("b", "P", "V_A", "omega_OA"))
    assert latex(product([(speed, 1), (b, 1)]), EN) == "bV_A"
    assert latex(product([(spin, 1), (b, 1), (speed, -1)]), EN) == r"\frac{b\omega_{OA}}{V_A}"
    assert latex(product([(load, 1), (speed, 1)]), EN) == "PV_A"
