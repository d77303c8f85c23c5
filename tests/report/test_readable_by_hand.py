"""Formulas as a person writes their angles: what an explanation may grow by."""

import pytest

from mechc.compilation import Compilation, compile_source
from mechc.formula.to_text import text
from mechc.formula.tree import Call, Symbol, product
from mechc.report.derivation.readable import ReadableDerivation
from mechc.report.kinds import SentenceKind
from mechc.report.steps import Equation, Explanation, Paragraph
from mechc.report.text.derivation import render
from mechc.source import Source

A, B, N = (Symbol(name) for name in ("alpha", "beta", "N"))


def readable() -> ReadableDerivation:
    """Return formulas of a plan in which every angle is to be turned by 90°."""
    found = object.__new__(ReadableDerivation)
    found._turns, found._found, found._ways = frozenset(), set(), set()
    found._ranges = dict  # type: ignore[assignment]
    found._values = lambda: {"alpha": 0.1, "beta": 0.2}  # type: ignore[assignment]
    found._quarter = lambda angle: 90  # type: ignore[assignment]
    return found


def explained(*factors) -> str:
    """Return the right-hand side of an equation, once it is explained."""
    side = product([(Call("cos", (factor,)), 1) for factor in factors])
    paragraph = Paragraph(SentenceKind.ALONG, (Equation(N, side),))
    (shown,) = readable().explanation(Explanation(("N",), (paragraph,)), ()).paragraphs
    return text(shown.equations[0].right)


def test_a_term_is_turned_that_grows_by_one_operation() -> None:
    assert explained(A) == "sin(alpha + pi/2)"


def test_a_term_is_left_that_would_grow_by_two() -> None:
    assert explained(A, B) == "cos(alpha)*cos(beta)"


def test_bars_stand_only_where_the_sign_is_open():
    """Over the ranges given cos β is positive; of a load, or without a range, nothing is known."""
    source = """
    mechanism crank
    param beta = 15 deg in 5 deg .. 40 deg
    pivot O
    slider B along x
    link OA
    link AB
    OA = 50 mm @ 60 deg
    AB = 200 mm @ -beta
    torque M on OA
    force F at B along -x
    find k = M/F
    find R_O
    """
    sizes = ("R_O = |F| / cos β", "R_O = |F| / |cos β|")
    for written, size in zip(
        (source, source.replace(" in 5 deg .. 40 deg", "")), sizes, strict=True
    ):
        found = compile_source(Source("crank.mech", written))
        assert isinstance(found, Compilation)
        lines = render(found.derivation, found.mechanism).splitlines()
        assert size in map(str.strip, lines)


@pytest.mark.parametrize(
    ("size", "shown", "is_said"),
    [
        ("", "R_O = |F| / cos β", True),
        ("let F = 2 kN", "R_O = F / cos β", False),
        ("let F = -2 kN", "R_O = −F / cos β", False),
    ],
)
def test_a_load_of_known_size_needs_neither_bars_nor_a_condition(size, shown, is_said) -> None:
    source = f"""
    mechanism crank
    param beta = 15 deg in 5 deg .. 40 deg
    pivot O
    slider B along x
    link OA
    link AB
    OA = 50 mm @ 60 deg
    AB = 200 mm @ -beta
    torque M on OA
    force F at B along -x
    friction slider B 0.1
    {size}
    find M
    find R_O
    """
    found = compile_source(Source("crank.mech", source))
    assert isinstance(found, Compilation)
    lines = [line.strip() for line in render(found.derivation, found.mechanism).splitlines()]
    assert shown in lines
    assert ("F > 0" in " ".join(lines)) == is_said
    assert any(text(one.formula) == "abs(F)/abs(cos(beta))" for one in found.results)


def test_angles_of_loops_need_neither_bars_nor_conditions() -> None:
    """beta is an arc sine, of something positive: only phi can turn the friction round."""
    source = """
    mechanism crank
    param r = 50 mm
    param l = 150 mm
    param phi = 50 deg in 20 deg .. 160 deg
    pivot O at (0 mm, 0 mm)
    slider B along x through O
    link OA
    link AB
    OA = r @ phi
    AB = l
    assembly B forward
    torque M on OA
    force F at B along x
    friction slider B 0.15
    find k = M/F
    find R_O
    """
    found = compile_source(Source("crank.mech", source))
    assert isinstance(found, Compilation)
    page = " ".join(render(found.derivation, found.mechanism).split())
    assert "This holds while sin(β_AB + φ) > 0." in page
    assert "R_O = |F| / cos β_AB" in page


def test_differences_are_one_way_round_on_a_page() -> None:
    """Friction has phi - phi_AB, whose sine is positive; the ratio, negative, has it as well."""
    source = """
    mechanism rocker
    param a = 40 mm
    param b = 120 mm
    param c = 80 mm
    param phi = 60 deg in 30 deg .. 150 deg
    pivot O at (0 mm, 0 mm)
    pivot Q at (100 mm, 0 mm)
    link OA
    link AB
    link QB
    OA = a @ phi
    AB = b
    QB = c
    assembly ABQ cw
    torque M on OA
    torque T on QB
    friction pins 0.1 diameter 10 mm
    find k = T/M
    """
    found = compile_source(Source("rocker.mech", source))
    assert isinstance(found, Compilation)
    page = " ".join(render(found.derivation, found.mechanism).split())
    assert "k = T/M = −c/a · sin μ_B / sin(φ − φ_AB)" in page
    assert "φ − δ_AB − φ_AB) − 2ρ > 0" in page
    assert "φ_AB − φ)" not in page.replace("μ_B + φ_AB − φ)", "")
