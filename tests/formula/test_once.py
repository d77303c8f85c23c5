"""Formulas as graphs: equal parts are one object, and each is met once."""

from mechc.formula.derivative import derivative
from mechc.formula.sharing import OneOfEach, each_part
from mechc.formula.tree import Call, Formula, Symbol, number, product, total
from mechc.formula.walk import Once, walk


def doubled(times: int) -> Formula:
    """Return a formula of 2^times sines, each level's two halves equal but not one."""
    if times == 0:
        return Call("sin", (Symbol("x"),))
    return Call("cos", (total([doubled(times - 1), Call("abs", (doubled(times - 1),))]),))


def test_equal_parts_become_one_object_and_nothing_else_changes():
    formula = doubled(8)
    shared = OneOfEach().of(formula)
    assert shared == formula
    assert len(list(each_part([shared]))) < 30 < len(list(walk(formula)))


def test_formulas_of_one_pool_share_parts():
    pool = OneOfEach()
    one, other = pool.of(doubled(3)), pool.of(product([(number(2), 1), (doubled(3), 1)]))
    assert other.factors[1] is one


def test_a_function_is_called_once_for_each_part():
    calls = []

    def count(formula):
        calls.append(formula)
        return 1

    once, formula = Once(count), doubled(2)
    assert once(formula) + once(formula) == 2
    assert len(calls) == 1
    once.forget()
    once(formula)
    assert len(calls) == 2


def test_a_slope_of_shared_parts_takes_no_longer_than_its_parts():
    """Two to the sixtieth paths lead to the innermost sine."""
    formula: Formula = Symbol("x")
    for _ in range(60):
        formula = Call("sin", (product([(formula, 1), (formula, 1)]),))
    assert len(list(each_part([derivative(formula, "x")]))) < 2000
