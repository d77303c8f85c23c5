"""When a loop closes: what is not negative there, and what has no value elsewhere.

A loop of which a direction turned out to be another one all the way has no margin: it closes
wherever that one does, as what vanishes over a part of the stroke vanishes over the whole.
"""

from collections.abc import Sequence

from ...formula.tree import ONE, Call, Formula, Implicit, Symbol, negative, total
from ...formula.walk import symbols, walk
from ..pose import ClosedLoop, Definition


def in_closed_form(loop: str, definitions: Sequence[Definition], root: Call) -> ClosedLoop:
    """Return a loop whose definitions rest on a root, or on an arc sine."""
    return ClosedLoop(loop, _resting_on(root, definitions), _margin(root))


def _margin(root: Call) -> Formula:
    """Return the expression that is not negative where a root or an arc sine has a value."""
    (inner,) = root.arguments
    return inner if root.function == "sqrt" else total([ONE, negative(Call("abs", (inner,)))])


def _resting_on(root: Call, definitions: Sequence[Definition]) -> frozenset[str]:
    names = set[str]()
    for name, formula in definitions:
        if root in walk(formula) or not names.isdisjoint(symbols(formula)):
            names.add(name)
    return frozenset(names)


def iterated(loop: str, definitions: Sequence[Definition]) -> ClosedLoop:
    """Return a loop that is closed by iteration: what it finds is NaN where the branch ends."""
    names = sorted(name for name, formula in definitions if isinstance(formula, Implicit))
    return ClosedLoop(loop, frozenset(names), Call("abs", (Symbol(names[0]),)))
