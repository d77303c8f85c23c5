"""Whether loops close, asked one by one of vectors that are written down by hand."""

import math

import pytest

from mechc.algebra.angle import Angle
from mechc.algebra.product import Product
from mechc.pose.closure_check import ClosingEquations, ClosureCondition
from mechc.pose.pose import Arm
from mechc.source import Span

HERE = Span(0, 1)
X, Y = Angle.constant(0), Angle.constant(90)
A, B, L = map(Product.symbol, "abl")
ALPHA, BETA = Angle.of("alpha"), Angle.of("beta")
POSES = [{"a": 1.0, "b": 2.0, "alpha": 0.3, "beta": 0.7, "l": 1.0}]


def loop(*arms, across=(X, Y), name="AB"):
    return ClosureCondition(name, tuple(Arm(size, along) for size, along in arms), across, HERE)


def codes(closure, *conditions):
    found = [closure.check(condition, lambda: POSES) for condition in conditions]
    return [None if one is None else one.code for one in found]


def test_a_vector_there_and_back_closes():
    assert codes(ClosingEquations(()), loop((A, ALPHA), (-A, ALPHA))) == [None]


def test_no_pose_is_asked_for_where_algebra_decides():
    there_and_back = loop((A, ALPHA), (-A, ALPHA))
    assert ClosingEquations(()).check(there_and_back, lambda: pytest.fail("a pose")) is None


def test_two_given_vectors_do_not():
    (code,) = codes(ClosingEquations(()), loop((A, ALPHA), (-B, BETA)))
    assert code is not None


def test_an_open_length_closes_one_direction_and_not_the_other():
    """l along alpha makes up for a along alpha, and not for b across it."""
    assert codes(ClosingEquations(["l"]), loop((A, ALPHA), (L, ALPHA))) == [None]
    across = ALPHA + Angle.constant(90)
    assert codes(ClosingEquations(["l"]), loop((A, ALPHA), (L, ALPHA), (B, across))) != [None]


def test_two_open_lengths_close_any_loop_once():
    ways = loop((A, ALPHA), (L, X), (Product.symbol("k"), Y))
    closure = ClosingEquations(["l", "k"])
    assert codes(closure, ways) == [None]
    other = loop((B, BETA), (L, X), (Product.symbol("k"), Y))
    assert codes(closure, other) != [None]


@pytest.mark.parametrize("across", [(X, Y), (ALPHA, ALPHA + Angle.constant(90))])
def test_a_loop_is_looked_at_along_an_open_length_and_across_it(across):
    """Across l the heights are equal by what beta is defined as; elsewhere l counts, too."""
    condition = loop((A, ALPHA), (-B, BETA), (L, X), across=across)
    poses = [{**POSES[0], "alpha": x, "beta": math.asin(math.sin(x) / 2)} for x in (0.3, 1.0)]
    assert ClosingEquations(["l"], defined=["beta"]).check(condition, lambda: poses) is None
    assert ClosingEquations(["l"]).check(condition, lambda: poses) is not None


def test_only_the_direction_that_is_asked_for_counts():
    """On its guide along x a point may be anywhere: its height alone must close."""
    assert codes(ClosingEquations(()), loop((A, X), across=(Y,))) == [None]
    assert codes(ClosingEquations(()), loop((A, X), across=(X,))) != [None]


def test_a_defined_angle_may_close_a_loop():
    """beta = asin(a·sin(alpha)/b): only numbers show that both heights are equal."""
    condition = loop((A, ALPHA), (-B, BETA), across=(Y,))
    poses = [
        {"a": 1.0, "b": 2.0, "alpha": x, "beta": math.asin(math.sin(x) / 2)} for x in (0.3, 1.0)
    ]
    assert ClosingEquations((), defined=["beta"]).check(condition, lambda: poses) is None
    assert ClosingEquations(()).check(condition, lambda: poses) is not None
    wrong = [poses[0], {**poses[1], "beta": 0.1}]
    assert ClosingEquations((), defined=["beta"]).check(condition, lambda: wrong) is not None
