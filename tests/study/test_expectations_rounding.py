"""True expectations stay true: where rounding is all there is, and where no pose is assembled."""

from random import Random

import pytest

import mechc
from mechc.compilation import compile_source
from mechc.formula.numeric.rounding import Rounding
from mechc.source import Source
from small_mechanisms import four_bar

TAN = """
param alpha = 60 deg in 10 deg .. 80 deg
param L = 80 mm
slider A along x
slider C along -y
link AC
AC = L @ {turn} + alpha
force P at A along x
force F at C along y
find k = P/F
"""

FOUR_BAR = four_bar(
    "find k = M/T",
    "let cm = cos(phi_AB - phi_O2B)",
    a="60 mm",
    b="80 mm",
    c="70 mm in 30 mm .. 400 mm",
    phi="60 deg in 0 deg .. 360 deg",
    drive="from 10 deg to 90 deg",
    assembly="ccw",
    pivots=("O1", "O2"),
)


def finding(text, expect):
    """Return the outcome of an expectation; MechcError where it is refuted."""
    (found,) = compile_source(Source("a.mech", text + expect)).findings
    return found


@pytest.mark.parametrize(
    ("turn", "expect"),
    [
        ("-150 deg", "expect k = tan(asin(sin(alpha)) - 60 deg)"),
        ("-150 deg", "expect k = 0 at alpha = 60 deg"),
        ("-90 deg", "expect k = tan(2*asin(sin(alpha/2)))"),
    ],
)
def test_a_zero_that_is_rounding_agrees(turn, expect):
    assert finding(TAN.format(turn=turn), expect).outcome == "agrees"


@pytest.mark.parametrize(
    "expect",
    [
        "expect k = tan(asin(sin(alpha)) - 60.0000001 deg)",
        "expect k = tan(asin(sin(alpha)) - 60 deg) + 1e-12",
        "expect k = 1e-13 at alpha = 60 deg",
    ],
)
def test_what_is_more_than_rounding_is_refuted(expect):
    with pytest.raises(mechc.MechcError) as error:
        finding(TAN.format(turn="-150 deg"), expect)
    assert [d.code for d in error.value.diagnostics if d.code[0] == "E"] == ["E581"]


def test_poses_that_cannot_be_assembled_refute_nothing():
    true = "expect cm = (b^2 + c^2 - (d^2+a^2-2*a*d*cos(phi)))/(2*b*c)"
    found = finding(FOUR_BAR, true)
    assert (found.outcome, found.poses) == ("agrees", 13)
    with pytest.raises(mechc.MechcError):
        finding(FOUR_BAR, true.replace("2*a*d", "2.0001*a*d"))


@pytest.mark.parametrize("literal", ["353e-3", "3.53e-1", "0.353", "35.3E-2", "0353e-3", "4e-1"])
def test_the_digits_of_a_figure_are_counted_in_whatever_form(literal):
    text = TAN.format(turn="-90 deg")
    assert finding(text, f"expect k = {literal} at alpha = 19.42 deg").outcome == "agrees"
    with pytest.raises(mechc.MechcError):
        finding(text, f"expect k = {literal} at alpha = 24.3 deg")


ZEROS = (
    "sin(a + b) - sin(a)*cos(b) - cos(a)*sin(b)",
    "asin(sin(a)) - a*1 rad",
    "sqrt(a*a + b*b) - hypot(a, b)",
    "tan(a - b) - (tan(a) - tan(b))/(1 + tan(a)*tan(b))",
    "(a + b)^3 - a^3 - 3*a^2*b - 3*a*b^2 - b^3",
    "atan2(sin(a), cos(a)) - a*1 rad",
)


def formula_of(text):
    """Return an expression in a and b, whose numbers count as radians, as a formula."""
    source = f"param a = 0.5 rad\nparam b = 0.25 rad\n{TAN.format(turn='-90 deg')}let z = {text}"
    return mechc.loads(source, "zero.mech").results["z"].formula


@pytest.mark.parametrize("text", ZEROS)
def test_rounding_is_bounded_and_not_by_much(text):
    """Formulas that are zero in exact arithmetic stay within their bound, and that is small."""
    dice, formula = Random(text), formula_of(text)
    for _ in range(100):
        found = Rounding({name: dice.uniform(0.1, 0.7) for name in "ab"}).of(formula)
        assert abs(found.value) <= 2 * found.error < 1e-12
