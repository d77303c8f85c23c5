"""Mechanisms of any size: the right k, and code that grows no faster than they do."""

from collections.abc import Callable
from functools import cache

import pytest

import reference_kinematics
from generators import (
    closed_four_bar_chain,
    coupler_chain,
    four_bar_chain,
    scissor,
    uneven_expectation,
    uneven_scissor,
)
from mechc.compilation import Compilation, compile_source
from mechc.routine.evaluate import evaluate
from mechc.routine.steps import Function
from mechc.source import Source
from mechc.work import MOST_WORK

CHAINS = (scissor, uneven_scissor, four_bar_chain, coupler_chain)

every_chain = pytest.mark.parametrize("chain", CHAINS, ids=lambda c: c.__name__)


@cache
def compiled(chain: Callable[[int], str], n: int) -> Compilation:
    return compile_source(Source("chain.mech", chain(n)))


def function_of(chain: Callable[[int], str], n: int) -> Function:
    return next(f for f in compiled(chain, n).routine.functions if f.name == "k")


@every_chain
@pytest.mark.parametrize("n", [1, 2, 3, 7])
def test_k_agrees_with_coordinates(chain: Callable[[int], str], n: int) -> None:
    tree = compiled(chain, n).tree
    values = reference_kinematics.results(tree)
    function = function_of(chain, n)
    found = evaluate(function, {i.name: values[i.name] for i in function.inputs})
    assert float(found) == pytest.approx(values["k"], rel=1e-9)


@pytest.mark.parametrize("n", [1, 2, 5])
def test_uneven_stages_add_up(n: int) -> None:
    text = uneven_scissor(n) + uneven_expectation(n)
    (finding,) = compile_source(Source("chain.mech", text)).findings
    assert finding.outcome == "proved"


@pytest.mark.parametrize("chain", [scissor, four_bar_chain, uneven_scissor, coupler_chain])
def test_operations_grow_as_the_stages_do(chain: Callable[[int], str]) -> None:
    few, many = (function_of(chain, n).operations for n in (6, 12))
    assert many <= 2.1 * few + 2


@pytest.mark.parametrize("n", [1, 2, 5])
def test_stages_of_a_scissor_only_multiply(n: int) -> None:
    assert function_of(scissor, n).operations <= 4


@pytest.mark.slow
def test_a_long_chain_of_loops_is_given_without_its_slope() -> None:
    """The slope nests a rate in a rate for each loop, deeper than can be written in the end."""
    short, long = (
        Compilation(Source("chain.mech", closed_four_bar_chain(n))).results[0] for n in (2, 40)
    )
    assert short.derivatives
    assert long.derivatives is None


def work_on_formulas(n: int) -> int:
    """Return the work on a chain of formulas of the user's own, each resting on the one before."""
    chain = [f"let a{i} = a{i - 1}*1.01 + 1" for i in range(1, n)]
    lines = [scissor(1), "let a0 = k*2", *chain]
    compilation = compile_source(Source("chain.mech", "\n".join(lines)))
    return MOST_WORK - compilation.allowance.left


def test_work_grows_as_the_formulas_of_a_chain_do() -> None:
    few, many = map(work_on_formulas, (60, 240))
    assert many < 5 * few
