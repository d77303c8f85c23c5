"""What every balance promises, on whole mechanisms; and that a broken promise is named."""

import pytest

from good_mechanisms import ALL, begun
from mechanisms import sample
from mechc.base.frozen import replace
from mechc.compilation import Compilation
from mechc.formula.tree import Symbol, product, total
from mechc.model.result import Definition
from mechc.power.promises import broken_promises
from mechc.source import Source
from mechc.units import FORCE


@pytest.mark.parametrize("name", ALL)
def test_promises_are_kept(name):
    assert broken_promises(begun(name).balance) == []


@pytest.mark.parametrize("seed", range(20))
def test_promises_are_kept_of_what_is_grown(seed):
    assert broken_promises(Compilation(Source("grown.mech", sample(seed).text)).balance) == []


def balance_of(*finds):
    """Return the balance of a lever with a second load F2."""
    lines = """
    param a = 300 mm
    param b = 200 mm
    pivot O
    link OAB
    OA = a @ 0 deg
    OB = b @ 90 deg
    force P at A along y
    force F at B along x
    force G at B along -y
    """
    text = "\n".join(line.strip() for line in (*lines.splitlines(), *finds))
    return Compilation(Source("lever.mech", text)).balance


def changed(balance, **fields):
    (solved,) = balance.solved
    return replace(balance, solved=[replace(solved, result=replace(solved.result, **fields))])


def test_a_ratio_that_does_not_balance_is_seen():
    balance = balance_of("find k = P/F")
    (solved,) = balance.solved
    wrong = replace(balance, solved=[replace(solved, value=-solved.value)])
    assert broken_promises(wrong) == ["k does not balance P and F"]


def test_a_sum_that_its_coefficients_do_not_give_is_seen():
    balance = balance_of("find P")
    whole = balance.solved[0].result.formula
    wrong = changed(balance, formula=total([whole, Symbol("F")]))
    assert broken_promises(wrong) == ["P is 1.9047619, by its coefficients 0.761904762"]


def test_a_coefficient_with_a_load_in_it_is_seen():
    balance = balance_of("find P")
    coefficients = {"F": Symbol("G")}
    assert "the coefficient of F in P uses load G" in broken_promises(
        changed(balance, coefficients=coefficients)
    )


def test_a_ratio_of_another_dimension_is_seen():
    wrong = changed(balance_of("find k = P/F"), dimension=FORCE)
    assert broken_promises(wrong) == ["k does not have its dimension"]


def test_a_formula_of_another_dimension_is_seen():
    balance = balance_of("find k = P/F")
    longer = product([(balance.solved[0].result.formula, 1), (Symbol("a"), 1)])
    assert broken_promises(changed(balance, formula=longer)) == ["k does not have its dimension"]


def test_names_that_mean_nothing_are_seen():
    balance = balance_of("find k = P/F")
    where = (Definition("beta", Symbol("gamma")), Definition("beta", Symbol("a")))
    assert broken_promises(changed(balance, formula=Symbol("delta"), where=where)) == [
        "beta of k uses gamma too early",
        "beta of k is defined twice",
        "k uses delta",
    ]


def test_a_column_without_what_is_tied_to_it_is_seen():
    balance = balance_of("find k = P/F")
    columns = {n: [-p for p in column] for n, column in balance.equations.columns.items()}
    negative = replace(balance.equations, columns=columns, powers=columns)
    assert broken_promises(replace(balance, equations=negative))[0] == (
        "the column of P is not the power of what is tied to it"
    )
