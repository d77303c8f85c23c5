"""The last step: the speeds found are put into the power equation, which gives P/F."""

from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise

from ...algebra.equality import equal
from ...algebra.from_formula import to_product
from ...formula.tree import Formula, Symbol, product, quotient
from ...formula.walk import symbols
from ...model.mechanism import LoadRatio, SpeedRatio
from ..sentences.wording import is_speed
from .steps import Derivation, Equation, LastStep, PowerTerm, SpeedChain, Step


def last_steps(derivation: Derivation) -> Iterator[LastStep]:
    """Yield the solution of the power equation for each ratio of two loads, in named speeds."""
    if len(derivation.balances) != 1:
        return
    terms = {term.load: term for term in derivation.terms}
    found = _found(derivation.steps)
    for result in derivation.results:
        target = result.target
        if isinstance(target, LoadRatio) and {target.above, target.below} == terms.keys():
            above, below = terms[target.above], terms[target.below]
            ratio = quotient(Symbol(target.above), Symbol(target.below))
            chain = _in_ratios(above, below, found)
            chain = None if chain and _has_other_sign(chain, derivation) else chain
            yield LastStep(chain, Equation(ratio, _ratio(above, below)))


def _has_other_sign(chain: SpeedChain, derivation: Derivation) -> bool:
    """Return whether a ratio of speeds that was asked for has a sign of its own.

    It is signed along a guide or counter-clockwise, those of the steps as points move.
    """
    for result in derivation.results:
        match result.target:
            case SpeedRatio(above, below):
                if quotient(Symbol(above.name), Symbol(below.name)) == chain.ratio:
                    return not equal(result.formula, chain.product)
    return False


def _ratio(above: PowerTerm, below: PowerTerm) -> Formula:
    """Return the ratio of two loads whose powers add up to zero."""
    powers = [to_product(t.times) * to_product(t.speed) for t in (above, below)]
    return (-(powers[1] / powers[0])).formula()


Found = Mapping[str, tuple[str, Formula]]
"""A speed's name, with the one that it was found from and its ratio to that."""


def _found(steps: Sequence[Step]) -> Found:
    found: dict[str, tuple[str, Formula]] = {}
    for step in steps:
        for left, right in step.results:
            speeds = [name for name in symbols(right) if is_speed(name)]
            if isinstance(left, Symbol) and len(speeds) == 1 and left.name != speeds[0]:
                factor = to_product(right) / to_product(Symbol(speeds[0]))
                if speeds[0] not in symbols(factor.formula()):
                    found[left.name] = speeds[0], factor.formula()
    return found


def _in_ratios(above: PowerTerm, below: PowerTerm, found: Found) -> SpeedChain | None:
    """Return the ratio of the speeds of two loads as a product, where it is found in steps."""
    speeds = [[n for n in sorted(symbols(t.speed)) if is_speed(n)] for t in (below, above)]
    if any(len(names) != 1 for names in speeds):
        return None
    (of,), (to,) = speeds
    chain = _chain(of, to, found)
    if len(chain) < 2:
        return None
    names = [of, *(found[name][0] for name in chain)]
    links = tuple(quotient(Symbol(a), Symbol(b)) for a, b in pairwise(names))
    whole = to_product(product((found[name][1], 1) for name in chain)).formula()
    return SpeedChain(quotient(Symbol(of), Symbol(to)), links, whole)


def _chain(of: str, to: str, found: Found) -> list[str]:
    """Return the speeds that lead from one to another, the last one left out; none if none do."""
    chain: list[str] = []
    while of != to:
        if of not in found or of in chain:
            return []
        chain.append(of)
        of = found[of][0]
    return chain
