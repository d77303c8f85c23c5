"""What is said of the power equation: its factors, and the projections of velocities in it."""

from collections.abc import Iterator, Sequence
from fractions import Fraction

from ...algebra.angle import Rational
from ...algebra.from_formula import to_product
from ...formula.layout import has_minus
from ...formula.tree import Formula, Product, Sum, Symbol, is_call, negative, number, product
from ...formula.walk import walk
from ...model.mechanism import Force, ForcePair, Load, Mechanism
from ..languages.locale import Locale
from ..steps import Derivation, PowerTerm
from .order import enumeration
from .speller import Speller, spelled


def power_remarks(
    derivation: Derivation, mechanism: Mechanism, locale: Locale, spell: Speller
) -> str:
    """Return the sentences on the power equation, or that there are several; '' where none are."""
    count = len(derivation.balances)
    if count > 1:
        return locale.several.format(count=count)
    terms = derivation.terms if count else ()
    powers = [power for balance in derivation.balances for power in _addends(balance.left)]
    said = (
        *_loads_of_equal_parts(terms, mechanism, locale, spell),
        *_projections(terms, powers, mechanism, locale, spell),
    )
    return " ".join(said)


def _projections(
    terms: Sequence[PowerTerm],
    powers: Sequence[Formula],
    mechanism: Mechanism,
    locale: Locale,
    spell: Speller,
) -> Iterator[str]:
    """Yield which projections of velocities forces work along, as the equation has them.

    So does a pair of forces one end of which stands still.
    """
    forces = {load.name for load in mechanism.loads if _is_at_one_point(load, mechanism)}
    found = [
        locale.powers["projection"].format(
            speed=spelled(_size(_written(term, powers)), spell),
            load=spelled(Symbol(term.load), spell),
        )
        for term in terms
        if term.load in forces and _is_projected(term.speed)
    ]
    if found:
        yield locale.powers["projections"].format(speeds=enumeration(found, locale))


def _is_at_one_point(load: Load, mechanism: Mechanism) -> bool:
    """Return whether a load does its work at one point."""
    match load:
        case Force():
            return True
        case ForcePair(first=first, second=second):
            return (first in mechanism.fixed) != (second in mechanism.fixed)
        case _:
            return False


def _is_projected(speed: Formula) -> bool:
    return any(is_call(part, "sin", "cos") for part in walk(speed))


def _addends(formula: Formula) -> tuple[Formula, ...]:
    return formula.terms if isinstance(formula, Sum) else (formula,)


def _written(term: PowerTerm, powers: Sequence[Formula]) -> Formula:
    """Return the speed along a load as the power equation has it: its sines may be turned there."""
    load = Symbol(term.load)
    own = (power.factors for power in powers if isinstance(power, Product))
    factors = next((found for found in own if load in found), None)
    if factors is None:
        return term.speed
    once = number(Fraction(1) / Fraction(to_product(term.times).coefficient))
    return product([(once, 1), *((factor, 1) for factor in factors if factor != load)])


def _size(speed: Formula) -> Formula:
    return negative(speed) if has_minus(speed) else speed


def _loads_of_equal_parts(
    terms: Sequence[PowerTerm], mechanism: Mechanism, locale: Locale, spell: Speller
) -> Iterator[str]:
    """Yield why loads are counted more than once: they act in several equal parts."""
    loads = {load.name: load for load in mechanism.loads}
    groups: dict[Rational, list[str]] = {}
    for term in terms:
        load = loads[term.load]
        times = to_product(term.times).coefficient
        if load.times == 1 and times > 1:
            groups.setdefault(times, []).append(spelled(Symbol(term.load), spell))
    for times, names in groups.items():
        is_mirrored = mechanism.mirror is not None and times == mechanism.mirror.number
        template = locale.powers["halves" if is_mirrored else "parts"]
        shown = spelled(number(times), spell)
        yield template.format(number=shown, loads=enumeration(names, locale))
