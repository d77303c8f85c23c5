"""A function of formulas that is called once for each part, however often the part is used."""

from collections.abc import Callable
from typing import Generic, TypeVar

from .tree import Formula

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
