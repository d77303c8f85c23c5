"""Common divisors of sums: found, cancelled, and never invented."""

from fractions import Fraction

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from mechc.algebra.angle import Angle
from mechc.algebra.gcd import common, degrees, divided, times
from mechc.algebra.laurent import Ring, size
from mechc.algebra.modular import PRIME, ModularPoint
from mechc.algebra.product import Product, Sum
from mechc.algebra.sums import MOST_MULTIPLIED_TERMS, add, canonical
from mechc.algebra.trigonometry import cosine, sine

law = settings(max_examples=60, deadline=None, derandomize=True, database=None)
A, B, C = map(Angle.of, ["alpha", "beta", "gamma"])
a, b, c = map(Product.symbol, "abc")


@st.composite
def polynomials(draw, variables=4):
    exponents = st.tuples(*[st.integers(0, 2)] * variables)
    terms = draw(st.dictionaries(exponents, st.integers(-5, 5).filter(bool), min_size=1))
    return {e: v % PRIME for e, v in list(terms.items())[:5]}


@law
@given(polynomials(), polynomials(), polynomials())
def test_what_two_polynomials_share_is_found(f, g, shared):
    found = common(times(f, shared), times(g, shared))
    for whole in (times(f, shared), times(g, shared)):
        assert times(divided(whole, found), found) == whole
    monomial = [min(column) for column in zip(*shared, strict=True)]
    reach = [d - m for d, m in zip(degrees(shared), monomial, strict=True)]
    assert all(map(int.__ge__, degrees(found), reach))


@law
@given(polynomials(), polynomials())
def test_what_remains_is_coprime(f, g):
    found = common(f, g)
    assert len(common(divided(f, found), divided(g, found))) == 1


@pytest.mark.parametrize(
    ("whole", "part"),
    [
        ({(2, 0): 1}, {(1, 1): 1}),  # x^2 by x·y
        ({(1, 0): 1, (0, 0): 1}, {(1, 0): 1, (0, 0): 2}),  # x + 1 by x + 2
    ],
)
def test_what_is_no_divisor_is_noticed(whole, part):
    """Division ends: the highest term falls with each of the quotient, none is negative."""
    with pytest.raises(AssertionError, match="not a divisor"):
        divided(whole, part)


SHARED = [
    add([a * cosine(A), b * sine(B)]),
    add([a, b * cosine(A - B)]),
    add([a * cosine(A + Angle.constant(45)), b * sine(B - Angle.constant(45))]),
    add([a * sine(A - Angle.constant(30)), c]),
    add([cosine(A + B), cosine(A).scaled(3)]),
    add([a * sine(A + Angle.constant(Fraction("12.34"))), b * cosine(B)]),
    add([a * sine(A + Angle.constant(18)), b * cosine(B - Angle.constant(36))]),
]
OTHERS = [
    (add([a * sine(C), b * cosine(A)]), add([c * sine(C), a * sine(B)])),
    (add([a, c]), add([a, -c])),
    (add([b * cosine(C - A), c]), add([b * cosine(C), a * sine(A + B)])),
]


@pytest.mark.parametrize("shared", SHARED)
@pytest.mark.parametrize("others", OTHERS)
def test_what_two_sums_share_is_cancelled(shared, others):
    upper, lower = others
    above, below = (expanded(x * shared) for x in others)
    assert canonical(above / below) == canonical(upper / lower)


def expanded(product):
    """Multiply out, so that nothing of the factors is to be seen."""
    ring = Ring([product])
    p = ring.expand([product])
    parts = (
        Product(p.scale, ring.monomial(k)) * part
        for k, v in p.terms.items()
        for part in ring.single(k, v)
    )
    assert size(product) <= MOST_MULTIPLIED_TERMS
    return Product.of(Sum(tuple(parts)))


@law
@given(st.permutations([A, B, C]), st.sampled_from([0, 45, 30, Fraction("12.34")]))
def test_coprime_sums_stay(angles, constant):
    x, y, z = angles
    upper = add([a * cosine(x + Angle.constant(constant)), b * sine(y)])
    lower = add([a * cosine(x + Angle.constant(constant)), b * sine(z)])
    assume(upper != lower)
    assert canonical(upper / lower).factors == {**(upper / lower).factors}


def test_the_quotient_keeps_its_value():
    for shared in SHARED:
        upper, lower = (expanded(x * shared) for x in OTHERS[0])
        point = ModularPoint(7)
        found = canonical(upper / lower).residue(point)
        assert found * lower.residue(point) % PRIME == upper.residue(point)
