"""Whether any value meets all comparisons with numbers, against trying values."""

import operator
from fractions import Fraction
from itertools import combinations, product

import pytest

from mechc.formula.tree import Call, Symbol, number
from mechc.model.formulas.choices import never_met

COMPARISONS = {
    "more": operator.gt,
    "at_least": operator.ge,
    "less": operator.lt,
    "at_most": operator.le,
    "same": operator.eq,
}
LINKS = list(product(COMPARISONS, (1, 2)))
TRIED = [Fraction(n, 4) for n in range(13)]
"""Numbers at, between and beyond those that are compared with."""


@pytest.mark.parametrize("range_", [None, (1, 2), (1.5, 1.75), (2, 3)])
@pytest.mark.parametrize("several", [1, 2, 3])
def test_no_value_meets_all_where_none_of_those_tried_does(several, range_):
    ranges = {"v": range_} if range_ else {}
    tried = [x for x in TRIED if not range_ or range_[0] <= x <= range_[1]]
    for links in combinations(LINKS, several):
        met = any(all(COMPARISONS[name](x, n) for name, n in links) for x in tried)
        asked = [Call(name, (Symbol("v"), number(n))) for name, n in links]
        assert never_met(asked, ranges) == ("" if met else "v"), links


@pytest.mark.parametrize(("turned", "plain"), [("more", "less"), ("at_most", "at_least")])
def test_a_number_may_stand_on_the_left(turned, plain):
    for n, m in product((1, 2), repeat=2):
        both = [Call(turned, (number(n), Symbol("v"))), Call(turned, (Symbol("v"), number(m)))]
        same = [Call(plain, (Symbol("v"), number(n))), Call(turned, (Symbol("v"), number(m)))]
        assert never_met(both, {}) == never_met(same, {})


def test_names_are_apart_and_other_comparisons_are_not_looked_at():
    v, w = Symbol("v"), Symbol("w")
    assert never_met([Call("more", (v, number(2))), Call("less", (w, number(1)))], {}) == ""
    assert never_met([Call("more", (v, w)), Call("less", (v, w))], {}) == ""
    below = [Call("less", (v, number(9))), Call("more", (w, number(5))), Call("less", (w, v))]
    assert never_met([*below, Call("at_most", (w, number(5)))], {}) == "w"
