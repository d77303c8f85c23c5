"""Walking over formulas: parts, symbols, substitution, and what is done once for each part."""

from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Generic, TypeVar, assert_never

from .tree import (
    Call,
    Compound,
    Constant,
    Formula,
    Implicit,
    Number,
    Pi,
    Power,
    Product,
    Sum,
    Symbol,
    System,
    power,
    product,
    total,
)


def children(formula: Formula) -> tuple[Formula, ...]:
    """Return the parts of a formula, left to right."""
    match formula:
        case Number() | Pi() | Symbol():
            return ()
        case Sum(terms):
            return terms
        case Product(factors):
            return factors
        case Power(base, exponent):
            return (base, exponent)
        case Call(_, arguments) | Implicit(_, _, arguments):
            return arguments
        case _:
            assert_never(formula)


def rebuild(formula: Formula, parts: tuple[Formula, ...]) -> Formula:
    """Return the formula with its children replaced (same kind, same number)."""
    match formula:
        case Number() | Pi() | Symbol():
            return formula
        case Sum():
            return total(parts)
        case Product():
            return product((p, 1) for p in parts)
        case Power():
            return power(*parts)
        case Call(function, _):
            return Call(function, parts)
        case Implicit(system, index, _):
            return Implicit(system, index, parts)
        case _:
            assert_never(formula)


def walk(formula: Formula) -> Iterator[Formula]:
    """Yield the formula and all its parts, parents first."""
    stack = [formula]
    while stack:
        node = stack.pop()
        yield node
        stack.extend(reversed(children(node)))


def symbols(*formulas: Formula) -> frozenset[str]:
    """Return the names that formulas depend on; a number under a name is none of them."""
    return frozenset[str]().union(*map(_names_in, formulas))


def _names_in(formula: Formula) -> frozenset[str]:
    """Return the names that one formula depends on, which are looked for once."""
    if not isinstance(formula, Compound):
        return frozenset(_own_name(formula))
    names: frozenset[str] | None = getattr(formula, "names_in_it", None)
    if names is None:
        names = _looked_for(formula)
        object.__setattr__(formula, "names_in_it", names)
    return names


def _looked_for(formula: Formula) -> frozenset[str]:
    """Return the names in a formula.

    What it shares is walked over once: parts, and the arguments of a system's unknowns.
    """
    names, met, stack = set[str](), set[int](), [formula]
    while stack:
        node = stack.pop()
        if not isinstance(node, Compound):
            names.update(_own_name(node))
            continue
        if node is not formula and isinstance(node, Call):
            names |= _names_in(node)  # many formulas have the same sine in them
            continue
        if known := getattr(node, "names_in_it", None):
            names |= known
            continue
        shared = node.arguments if isinstance(node, Implicit) else node
        if id(shared) not in met:
            met.add(id(shared))
            stack.extend(children(node))
    return frozenset(names)


def _own_name(formula: Formula) -> tuple[str, ...]:
    """Return the name of a symbol; what else has no parts has none."""
    if isinstance(formula, Symbol) and not isinstance(formula, Constant):
        return (formula.name,)
    return ()


class Mentions:
    """The names that each of several formulas depends on.

    Those in the arguments of a system, which all of its unknowns share, are looked for once.
    """

    def __init__(self) -> None:
        self._shared: dict[int, tuple[Formula, frozenset[str]]] = {}

    def of(self, formula: Formula) -> frozenset[str]:
        """Return the names that one formula depends on."""
        if not isinstance(formula, Implicit):
            return symbols(formula)
        here = id(formula.arguments)
        if here not in self._shared:
            self._shared[here] = formula, symbols(formula)
        return self._shared[here][1]


def reached(names: Iterable[str], formulas: Mapping[str, Formula]) -> set[str]:
    """Return which formulas names lead to: their own, and those of the symbols in these.

    >>> from .tree import Symbol
    >>> sorted(reached(["a"], {"a": Symbol("b"), "b": Symbol("x"), "c": Symbol("a")}))
    ['a', 'b']
    """
    found, waiting = set[str](), list(names)
    while waiting:
        name = waiting.pop()
        if name in formulas and name not in found:
            found.add(name)
            waiting += symbols(formulas[name])
    return found


def constants(formulas: Iterable[Formula]) -> list[Constant]:
    """Return the numbers under names that are read in formulas, each once, systems included."""
    found: dict[Constant, None] = {}
    waiting, systems = list(formulas)[::-1], set[System]()
    while waiting:
        part = waiting.pop()
        if isinstance(part, Constant):
            found[part] = None
        if isinstance(part, Implicit) and part.system not in systems:
            systems.add(part.system)
            waiting.extend(part.system.equations)
        waiting.extend(reversed(children(part)))
    return list(found)


def substitute(formula: Formula, values: Mapping[str, Formula]) -> Formula:
    """Return the formula with symbols replaced by formulas."""
    return Substitution(values).of(formula)


class Substitution:
    """Formulas with symbols replaced by formulas.

    What all unknowns of a system have as arguments is replaced once, and is shared again.
    """

    def __init__(self, values: Mapping[str, Formula]) -> None:
        self._values = values
        self._shared: dict[int, tuple[tuple[Formula, ...], tuple[Formula, ...]]] = {}

    def of(self, formula: Formula) -> Formula:
        """Return one formula with its symbols replaced."""
        match formula:
            case Symbol(name):
                return self._values.get(name, formula)
            case Implicit(system, index, arguments):
                return Implicit(system, index, self._of_a_system(arguments))
            case _:
                parts = children(formula)
                return rebuild(formula, tuple(map(self.of, parts))) if parts else formula

    def _of_a_system(self, arguments: tuple[Formula, ...]) -> tuple[Formula, ...]:
        if id(arguments) not in self._shared:
            self._shared[id(arguments)] = arguments, tuple(map(self.of, arguments))
        return self._shared[id(arguments)][1]


T = TypeVar("T")


class Once(Generic[T]):
    """A function that is called once for each formula; formulas are known by identity.

    >>> from .tree import PI
    >>> called = []
    >>> times = Once(lambda formula: called.append(formula))
    >>> times(PI), times(PI), len(called)
    (None, None, 1)
    """

    def __init__(self, function: Callable[[Formula], T]) -> None:
        self._function = function
        self._known: dict[int, T] = {}
        self._alive: list[Formula] = []

    def __call__(self, formula: Formula) -> T:
        """Return the function's value; the formula is kept, so that no other takes its identity."""
        key = id(formula)
        if key not in self._known:
            self._known[key] = self._function(formula)
            self._alive.append(formula)
        return self._known[key]

    def forget(self) -> None:
        """Drop the values: what they depended on has changed."""
        self._known.clear()
        self._alive.clear()
