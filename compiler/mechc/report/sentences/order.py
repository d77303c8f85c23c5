"""Items and terms in the order in which they are read, whoever prints."""

from collections.abc import Iterable, Set

from ...formula.layout import has_minus
from ...formula.rewriting import by_opposite, by_tangent, in_reading_order, rewritten
from ...formula.tree import Call, Formula, Product, Sum, negative, total
from ...formula.walk import symbols
from ..languages.locale import Locale


def enumeration(items: Iterable[str], locale: Locale) -> str:
    """Return ``A, B and C`` in the table's language."""
    return joined(items, locale.conjunction)


def alternatives(items: Iterable[str], locale: Locale) -> str:
    """Return ``A, B or C`` in the table's language."""
    return joined(items, locale.disjunction)


def joined(items: Iterable[str], word: str) -> str:
    """Return items with commas between them, and a word before the last one.

    >>> joined("ABC", "or"), joined("A", "or")
    ('A, B or C', 'A')
    """
    *most, last = items
    return f"{', '.join(most)} {word} {last}" if most else last


def positive_first(terms: Iterable[Formula]) -> list[Formula]:
    """Return terms with one that has no minus in front, where there is one.

    >>> from ...formula.tree import Symbol, degrees, negative, total
    >>> from ...formula.to_text import text
    >>> text(total(positive_first([negative(Symbol("theta")), degrees(180)])))
    'pi - theta'
    """
    ordered = list(terms)
    lead = next((i for i, t in enumerate(ordered) if not has_minus(t)), 0)
    return [*ordered[lead : lead + 1], *ordered[:lead], *ordered[lead + 1 :]]


def geometry_first(formula: Formula, turns: Set[str]) -> Formula:
    """Return a formula with ``sin(α − δ)`` for ``−sin(δ − α)``, δ one of the turns by friction.

    >>> from ...formula.tree import Call, Symbol, negative, product, total
    >>> from ...formula.to_text import text
    >>> sine = Call("sin", (total([Symbol("delta"), negative(Symbol("alpha"))]),))
    >>> text(geometry_first(product([(Symbol("S"), 1), (sine, 1)]), {"delta"}))
    '-S*sin(alpha - delta)'
    >>> cosine = Call("cos", (total([Symbol("alpha"), negative(Symbol("delta"))]),))
    >>> text(geometry_first(product([(sine, 1), (cosine, -1)]), {"delta"}))
    '-tan(alpha - delta)'
    >>> text(geometry_first(product([(sine, -1), (cosine, 1)]), {"delta"}))
    '-cot(alpha - delta)'
    >>> angle = total([Symbol("alpha"), negative(Symbol("delta")), Symbol("phi")])
    >>> text(geometry_first(Call("cos", (angle,)), {"delta"}))
    'cos(alpha + phi - delta)'
    """

    def first(whole: Formula) -> Formula | None:
        match whole:
            case Call("sin" | "cos" as function, (Sum(terms),)) if _led_by(terms, turns):
                return by_opposite(function, _turned_round(terms))
            case Call("sin" | "cos" as function, (Sum(terms),)) if _takes_away(terms, turns):
                return Call(function, (total(in_reading_order(terms)),))
            case Product(factors):
                return by_tangent(factors)
            case Call("hypot" | "abs" as size, of):
                return Call(size, tuple(negative(part) if has_minus(part) else part for part in of))
        return None

    return rewritten(formula, first)


def _turned_round(terms: Iterable[Formula]) -> Formula:
    return total(positive_first(map(negative, terms)))


def _takes_away(terms: Iterable[Formula], turns: Set[str]) -> bool:
    """Return whether turns are taken away: they stand behind what is added."""
    return any(has_minus(term) and symbols(term) <= turns for term in terms)


def _led_by(terms: Iterable[Formula], turns: Set[str]) -> bool:
    """Return whether all that is added are turns, and something else is taken away."""
    signed = [(has_minus(term), symbols(term) <= turns) for term in terms]
    return all(turned for minus, turned in signed if not minus) and (True, False) in signed
