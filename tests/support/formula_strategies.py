"""Random formulas, with values of their letters."""

import math

from hypothesis import strategies as st

from mechc.formula.tree import (
    Call,
    Formula,
    Symbol,
    degrees,
    negative,
    number,
    power,
    product,
    total,
)

VALUES = {"a": 1.3, "b": 0.7, "c": 2.1, "alpha": 0.4, "beta": 0.9, "theta": 0.25, "pi": math.pi}


numbers = st.fractions(-4, 4, max_denominator=10).map(number)


letters = st.sampled_from("abc").map(Symbol)


angles = st.one_of(
    st.sampled_from(["alpha", "beta", "theta"]).map(Symbol),
    st.integers(1, 179).map(degrees),
    st.builds(
        lambda n, m: total([product([(number(n), 1), (Symbol("alpha"), 1)]), degrees(m)]),
        st.integers(-3, 3),
        st.sampled_from([-90, 40, 90]),
    ),
    st.permutations([Symbol("theta"), negative(Symbol("beta")), degrees(19)]).map(total),
)


calls = st.builds(lambda f, x: Call(f, (x,)), st.sampled_from(["sin", "cos", "tan", "cot"]), angles)


def grown(inner: st.SearchStrategy[Formula]) -> st.SearchStrategy[Formula]:
    factors = st.lists(
        st.tuples(inner, st.sampled_from([1, 1, 1, 2, -1, -2])), min_size=2, max_size=4
    )
    return st.one_of(
        st.lists(inner, min_size=2, max_size=4).map(total),
        factors.filter(lambda fs: all(f != number(0) for f, _ in fs)).map(product),
        inner.map(negative),
        inner.map(lambda f: Call("exp", (f,))),
        inner.map(lambda f: power(f, number(2))),
    )


formulas = st.recursive(st.one_of(numbers, letters, calls), grown, max_leaves=8)
