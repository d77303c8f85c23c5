"""Large formulas as graphs: equal parts are one object, and a pass meets each of them once.

The equations of friction in a train of loops repeat the same forces again and again: written
out they have thirty times as many parts as there are different ones.
"""

from collections.abc import Iterable, Iterator

from .tree import Call, Constant, Formula, Implicit, Number, Pi, Power, Product, Sum, Symbol
from .walk import Once, children


class OneOfEach:
    """Makes equal parts of formulas one object.

    >>> a = OneOfEach().of(Sum((Call("sin", (Symbol("x"),)), Call("sin", (Symbol("x"),)))))
    >>> a.terms[0] is a.terms[1]
    True
    """

    def __init__(self) -> None:
        self._of = Once(self._found)
        self._parts: dict[object, Formula] = {}

    def of(self, formula: Formula) -> Formula:
        """Return an equal formula, made of the parts that were met before."""
        return self._of(formula)

    def _found(self, formula: Formula) -> Formula:
        parts = tuple(map(self._of, children(formula)))
        return self._parts.setdefault(_key(formula, parts), _made_of(formula, parts))


def _key(formula: Formula, parts: tuple[Formula, ...]) -> object:
    """Return the key of a formula; equal keys make equal formulas, their parts being these."""
    own: object
    match formula:
        case Implicit(system, index, _):
            own = (id(system), index)
        case Call(function, _):
            own = function
        case Number() | Symbol():
            own = formula
        case _:
            own = None
    return type(formula), own, *map(id, parts)


def _made_of(formula: Formula, parts: tuple[Formula, ...]) -> Formula:
    """Return a formula with equal parts, as it is written."""
    if all(one is other for one, other in zip(children(formula), parts, strict=True)):
        return formula
    match formula:
        case Sum():
            return Sum(parts)
        case Product():
            return Product(parts)
        case Power():
            return Power(*parts)
        case Call(function, _):
            return Call(function, parts)
        case Implicit(system, index, _):
            return Implicit(system, index, parts)
        case Number() | Pi() | Symbol() | Constant():
            return formula


def each_part(formulas: Iterable[Formula]) -> Iterator[Formula]:
    """Yield every part of formulas once, however often it is used, parents first."""
    met = set[int]()
    for formula in formulas:
        stack = [formula]
        while stack:
            node = stack.pop()
            if id(node) not in met:
                met.add(id(node))
                yield node
                stack.extend(reversed(children(node)))
