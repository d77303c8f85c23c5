"""The order in which sums of forces and moments give a load, on sums that are written down."""

import pytest

from mechc.algebra.product import Product
from mechc.equilibrium.equilibrium import EquilibriumSum
from mechc.equilibrium.order import candidates, steps_to
from mechc.formula.to_text import text

P, Q, A, B, C, D = "PQABCD"


def balance(**terms):
    """Return a sum in which each force counts so often."""
    return EquilibriumSum("body", {name: Product(n) for name, n in terms.items()})


def steps(sums, load=P, known=(Q,), avoided=()):
    able = candidates(sums, frozenset(known), {}, frozenset())
    return steps_to(load, able, frozenset(avoided))


def found(sums, **more):
    """Return the forces of each step, and the load in what is known."""
    taken = steps(sums, **more)
    return [[f.name for f in step.found] for step in taken]


def share(sums, **more):
    (last,) = steps(sums, **more)[-1].found
    return {name: text(part.formula()) for name, part in last.terms.items()}


def test_one_sum_is_enough():
    sums = [balance(P=1, Q=-3)]
    assert found(sums) == [[P]]
    assert share(sums) == {Q: "3"}


def test_one_force_after_another():
    sums = [balance(P=1, A=2), balance(A=1, Q=4)]
    assert found(sums) == [[A], [P]]
    assert share(sums) == {A: "-2"}


def test_what_the_load_does_not_rest_on_is_left_out():
    sums = [balance(P=1, Q=1), balance(A=1, Q=1), balance(B=1, A=1)]
    assert found(sums) == [[P]]


def test_two_sums_together():
    """P + A = Q and P - A = Q: the load is Q, by both."""
    sums = [balance(P=1, A=1, Q=-1), balance(P=1, A=-1, Q=-1)]
    assert found(sums) == [[P]]
    (step,) = steps(sums)
    assert len(step.balances) == 2
    assert share(sums) == {Q: "1"}


def test_three_sums_of_two_forces_each():
    """P + A = Q, A + B = 0 and B + P = Q: no two of them have two forces alone."""
    sums = [balance(P=1, A=1, Q=-1), balance(A=1, B=1), balance(B=1, P=1, Q=-1)]
    (step,) = steps(sums)
    assert len(step.balances) == 3
    assert share(sums) == {Q: "1"}


def test_two_sums_go_before_three():
    sums = [
        balance(P=1, A=1, Q=-1),
        balance(A=1, B=1),
        balance(B=1, P=1, Q=-1),
        balance(P=2, A=-1, Q=-1),
    ]
    (step,) = steps(sums)
    assert len(step.balances) == 2


@pytest.mark.parametrize(
    "sums",
    [
        [],
        [balance(P=1, A=1)],
        [balance(P=1, A=1, Q=-1), balance(P=2, A=2, Q=-2)],  # the same twice
        [balance(A=1, Q=1)],
        [  # four at once
            balance(P=1, A=1, Q=-1),
            balance(A=1, B=1),
            balance(B=1, C=1),
            balance(C=1, P=1, Q=-2),
        ],
    ],
)
def test_nothing_leads_to_the_load(sums):
    assert steps(sums) == ()


def test_a_force_that_is_zero_is_put_into_nothing():
    """A = 0, so that P = Q alone."""
    sums = [balance(A=1), balance(P=1, A=5, Q=-1)]
    assert share(sums) == {Q: "1"}


def test_avoided_forces_are_found_last():
    sums = [balance(A=1, Q=1), balance(B=1, Q=2), balance(P=1, A=1), balance(P=1, B=1, Q=1)]
    assert found(sums, avoided=[A]) == [[B], [P]]
    assert found(sums, avoided=[B]) == [[A], [P]]
