"""The last step: the speeds found are put into the power equation, which gives P/F."""

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import pairwise

from ...algebra.equality import equal
from ...algebra.factoring import content_of
from ...algebra.from_formula import to_product
from ...algebra.product import Product
from ...formula.layout import has_minus
from ...formula.tree import Formula, Sum, Symbol, negative, number, product, quotient, total
from ...formula.walk import symbols
from ...model.mechanism import LoadRatio, SpeedRatio
from ..sentences.order import positive_first
from ..sentences.wording import is_speed
from ..steps import Derivation, DerivationStep, Equation, LastStep, PowerTerm, SpeedChain

Owners = Mapping[str, tuple[str, Product]]
"""The load that each is tied to, itself where it is free, and the factor."""


def last_steps(derivation: Derivation, owners: Owners) -> Iterator[LastStep]:
    """Yield the solution of the power equation for each ratio of two loads, in named speeds."""
    if len(derivation.balances) != 1:
        return
    terms = {term.load: term for term in derivation.terms}
    found, stated = _found(derivation.steps), set[frozenset[str]]()
    for target in (r.target for r in derivation.results if isinstance(r.target, LoadRatio)):
        ratio = quotient(Symbol(target.above), Symbol(target.below))
        if {target.above, target.below} == terms.keys():
            above, below = terms[target.above], terms[target.below]
            chain = _in_ratios(above, below, found)
            speeds = frozenset(symbols(chain.ratio)) if chain else frozenset()
            if chain and (speeds in stated or _has_other_sign(chain, derivation)):
                chain = None
            stated.add(speeds)
            yield LastStep(chain, Equation(ratio, _ratio(above, below)))
        elif whole := _of_tied(target, derivation.terms, owners):
            yield LastStep(None, Equation(ratio, whole))


def _of_tied(target: LoadRatio, terms: Sequence[PowerTerm], owners: Owners) -> Formula | None:
    """Return a ratio of loads to which all others are tied; None where there are more."""
    asked = (target.above, target.below)
    if any(owners[name][0] != name for name in asked):
        return None
    powers: dict[str, list[tuple[Product, Formula]]] = {name: [] for name in asked}
    for term in terms:
        owner, factor = owners[term.load]
        if owner not in powers:
            return None
        powers[owner].append((to_product(term.times) * factor, term.speed))
    if not all(powers.values()):
        return None
    (above, above_number), (below, below_number) = (_sum_and_number(powers[n]) for n in asked)
    share = number(below_number / above_number)
    if all(map(has_minus, getattr(above, "terms", (above,)))):
        return product([(share, 1), (quotient(below, negative(above)), 1)])
    if any(map(has_minus, getattr(below, "terms", (below,)))):
        return product([(share, 1), (quotient(_turned(below), above), 1)])
    return product([(share, 1), (number(-1), 1), (quotient(below, above), 1)])


def _turned(whole: Formula) -> Formula:
    """Return a sum with the opposite sign, a positive term first."""
    terms = whole.terms if isinstance(whole, Sum) else (whole,)
    return total(positive_first(map(negative, terms)))


def _sum_and_number(powers: Sequence[tuple[Product, Formula]]) -> tuple[Formula, Fraction]:
    """Return a sum of powers without the number that all of its terms have, and that number."""
    content = content_of(times.coefficient for times, _ in powers)
    terms = [
        product([(times.scaled(1 / Fraction(content)).formula(), 1), (speed, 1)])
        for times, speed in powers
    ]
    return total(positive_first(terms)), Fraction(content)


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


FoundSpeeds = Mapping[str, tuple[str, Formula]]
"""A speed's name, with the one that it was found from and its ratio to that."""


def _found(steps: Sequence[DerivationStep]) -> FoundSpeeds:
    """Return the speeds that steps find from one other speed each, in proportion to it."""
    found: dict[str, tuple[str, Formula]] = {}
    for left, right in (equation for step in steps for equation in step.results):
        speeds = [name for name in symbols(right) if is_speed(name)]
        if isinstance(left, Symbol) and len(speeds) == 1 and left.name != speeds[0]:
            factor = to_product(right) / to_product(Symbol(speeds[0]))
            if speeds[0] not in symbols(factor.formula()):
                found[left.name] = speeds[0], factor.formula()
    return found


def _in_ratios(above: PowerTerm, below: PowerTerm, found: FoundSpeeds) -> SpeedChain | None:
    """Return the ratio of the speeds of two loads as a product, where it is found in steps."""
    speeds = [[n for n in sorted(symbols(t.speed)) if is_speed(n)] for t in (below, above)]
    if any(len(names) != 1 for names in speeds):
        return None
    (of,), (to,) = speeds
    chain, exponent = _chain(of, to, found), 1
    if not chain:
        chain, exponent = _chain(to, of, found), -1
    if len(chain) < 2:
        return None
    names = [chain[0], *(found[name][0] for name in chain)][::exponent]
    links = tuple(quotient(Symbol(a), Symbol(b)) for a, b in pairwise(names))
    whole = to_product(product((found[name][1], exponent) for name in chain)).formula()
    return SpeedChain(quotient(Symbol(of), Symbol(to)), links, whole)


def _chain(of: str, to: str, found: FoundSpeeds) -> list[str]:
    """Return the speeds that lead from one to another, the last one left out; none if none do."""
    chain: list[str] = []
    while of != to:
        if of not in found or of in chain:
            return []
        chain.append(of)
        of = found[of][0]
    return chain
