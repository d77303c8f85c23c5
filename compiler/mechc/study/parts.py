"""Parts of a ratio by themselves, as definitions of a result: its factors, signs in it."""

from collections.abc import Iterable, Iterator, Mapping

from ..formula.tree import ZERO, Formula, Power, Product, Symbol
from ..formula.walk import symbols
from ..frozen import replace
from ..model.result import Definition, Result
from .sweep import VALUE


def factors(formula: Formula, where: Mapping[str, Formula]) -> Iterator[Formula]:
    """Yield what a formula is a product of, powers and the names of definitions taken apart.

    >>> from ..formula.tree import Call, quotient
    >>> k = quotient(Call("sin", (Symbol("t"),)), Symbol("i"))
    >>> list(factors(k, {"i": Symbol("r")}))
    [Call(function='sin', arguments=(Symbol(name='t'),)), Symbol(name='r')]
    """
    match formula:
        case Product(parts):
            for part in parts:
                yield from factors(part, where)
        case Power(base, _):
            yield from factors(base, where)
        case Symbol(name) if name in where:
            yield from factors(where[name], where)
        case _:
            yield formula


def parts_of(result: Result, parts: Iterable[Formula]) -> Result:
    """Return a result whose last definitions are parts of another, after what they rest on."""
    where = [Definition(f"{VALUE}{i}", part) for i, part in enumerate(dict.fromkeys(parts))]
    needed = frozenset[str]().union(*(symbols(part.formula) for part in where))
    for definition in reversed(result.where):
        if definition.name in needed:
            where.insert(0, definition)
            needed |= symbols(definition.formula)
    return replace(result, formula=ZERO, where=tuple(where), guards=())


def is_part(definition: Definition) -> bool:
    """Return whether a definition is one of the parts."""
    return definition.name.startswith(VALUE)
