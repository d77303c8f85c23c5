"""Bounds of angles over ranges, by hand."""

import math

import pytest

from mechc.algebra.angle import Angle
from mechc.algebra.factors import Trig
from mechc.algebra.intervals import NumberInterval, angle_bounds, vanishing_values
from mechc.formula.to_text import text

BOX = {"alpha": NumberInterval(0.1, 0.3), "beta": NumberInterval(-0.2, 0.5)}
ALPHA, BETA = Angle.of("alpha"), Angle.of("beta")


@pytest.mark.parametrize(
    ("angle", "low", "high"),
    [
        (ALPHA, 0.1, 0.3),
        (ALPHA + BETA, -0.1, 0.8),
        (ALPHA - BETA, -0.4, 0.5),
        (ALPHA + ALPHA - BETA + Angle.constant(30), 0.2 - 0.5 + math.pi / 6, 0.8 + math.pi / 6),
        (Angle.constant(90), math.pi / 2, math.pi / 2),
    ],
)
def test_the_bounds_of_a_sum_are_sums_of_bounds(angle: Angle, low: float, high: float) -> None:
    found = angle_bounds(angle, BOX)
    assert found == (pytest.approx(low, rel=1e-12), pytest.approx(high, rel=1e-12))
    assert found.low <= low
    assert found.high >= high


def test_an_angle_without_a_range_may_be_any() -> None:
    assert angle_bounds(ALPHA + Angle.of("gamma"), BOX) == (-math.inf, math.inf)


# ------------------------------------------------------------------------------- roots

PHI = Angle.of("phi")
TURN, HALF = NumberInterval(0.0, 2 * math.pi), NumberInterval(0.0, math.pi)
SMALL = NumberInterval(0.0, 0.5)


@pytest.mark.parametrize(
    ("function", "angle", "box", "within"),
    [
        ("cos", PHI, {"phi": TURN}, ["pi/2", "3*pi/2"]),
        ("sin", PHI, {"phi": TURN}, ["0", "pi", "2*pi"]),
        ("sin", PHI * 2 - Angle.constant(60), {"phi": HALF}, ["pi/6", "2*pi/3"]),
        ("cos", PHI, {"phi": SMALL}, []),
        ("cos", PHI, {}, []),
        ("sin", PHI + BETA, {"phi": HALF, "beta": SMALL}, ["-beta + pi"]),
        ("sin", PHI - BETA, {"phi": HALF, "beta": SMALL}, ["beta"]),
        ("sin", PHI - BETA, {"phi": TURN, "beta": NumberInterval(-0.5, 0.5)},
         ["beta", "beta + pi", "beta + 2*pi"]),
        ("sin", PHI - BETA, {"phi": HALF}, ["beta"]),
    ],
)  # fmt: skip
def test_all_roots_within_a_range_are_listed(function, angle, box, within) -> None:
    found = vanishing_values(Trig(function, angle), {"phi": 0.7, "beta": 0.2}, box, ["phi"])
    assert found is not None
    assert found.name == "phi"
    assert sorted(map(text, found.within)) == sorted(within)
    assert not found.is_many
    assert not found.within or found.nearest in found.within


def test_of_many_roots_the_first_is_given_with_what_lies_between_two() -> None:
    near = {"phi": 0.7}
    found = vanishing_values(Trig("cos", PHI * 3), near, {"phi": TURN}, ["phi"])
    assert found is not None
    assert (found.is_many, [*map(text, found.within)], text(found.period)) == (
        True,
        ["pi/6"],
        "pi/3",
    )
    assert text(found.nearest) == "pi/6"


def test_the_root_that_is_named_is_within_the_range_of_its_symbol() -> None:
    """sin(φ + β) with φ = 178°, β = −20°: the nearest root, 200°, is beyond 180°."""
    near = {"phi": math.radians(178), "beta": math.radians(-20)}
    found = vanishing_values(Trig("sin", PHI + BETA), near, {"phi": HALF}, ["phi"])
    assert found is not None
    assert text(found.nearest) == "-beta"
