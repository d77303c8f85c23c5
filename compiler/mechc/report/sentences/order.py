"""Items and terms in the order in which they are read, whoever prints."""

from collections.abc import Iterable, Sequence, Set

from ...formula.layout import has_minus
from ...formula.tree import Call, Formula, Power, Product, Sum, negative, number, product, total
from ...formula.walk import children, rebuild, symbols
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
    """
    parts = tuple(geometry_first(part, turns) for part in children(formula))
    whole = rebuild(formula, parts) if parts else formula
    match whole:
        case Call("sin", (Sum(terms),)) if _led_by(terms, turns):
            return negative(Call("sin", (_turned_round(terms),)))
        case Call("cos", (Sum(terms),)) if _led_by(terms, turns):
            return Call("cos", (_turned_round(terms),))
        case Product(factors) if whole != formula:
            return _by_tangent(factors) or whole
        case Call("hypot" | "abs" as size, of):
            return Call(size, tuple(negative(part) if has_minus(part) else part for part in of))
        case _:
            return whole


def _by_tangent(factors: Sequence[Formula]) -> Formula | None:
    """Return a product with the tangent of an angle for its sine over its cosine; None if none."""
    for factor in factors:
        if isinstance(factor, Call) and factor.function == "sin":
            below = Power(Call("cos", factor.arguments), number(-1))
            if below in factors:
                others = (f for f in factors if f not in (factor, below))
                return product((f, 1) for f in (*others, Call("tan", factor.arguments)))
    return None


def _turned_round(terms: Iterable[Formula]) -> Formula:
    return total(positive_first(map(negative, terms)))


def _led_by(terms: Iterable[Formula], turns: Set[str]) -> bool:
    """Return whether all that is added are turns, and something else is taken away."""
    signed = [(has_minus(term), symbols(term) <= turns) for term in terms]
    return all(turned for minus, turned in signed if not minus) and (True, False) in signed
