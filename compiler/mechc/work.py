"""How much work one compilation may do, counted, so that none goes on without end.

What is counted are elementary steps of algebra: terms of sums added, multiplied and
divided, factors compared, each as dear as a microsecond or so; and operations on floats
where formulas are evaluated and systems solved, several to a step. The count depends on
the description alone, never on the machine or its load; steps of algebra whose results
are kept for later (``lru_cache``) are not counted, those of :func:`kept` and ways to numeric
solutions always. The allowance is a context variable, so that compilations in other threads
have their own.

>>> with at_most(Allowance(3)):
...     spend(2)
>>> with at_most(Allowance(3)):
...     spend(4)
Traceback (most recent call last):
mechc.work.WorkLimitError
"""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from functools import lru_cache, wraps
from typing import ParamSpec, TypeVar

P = ParamSpec("P")
T = TypeVar("T")

MOST_WORK = 10_000_000
"""Steps of one compilation: some ten seconds; no mechanism of the library takes a tenth."""


class WorkLimitError(Exception):
    """Raised where a compilation has used up its allowance."""


class Allowance:
    """The steps that are left."""

    __slots__ = ("left",)

    def __init__(self, steps: int = MOST_WORK) -> None:
        self.left = steps


_ALLOWANCE: ContextVar[Allowance | None] = ContextVar("allowance", default=None)


@contextmanager
def at_most(allowance: Allowance) -> Iterator[Allowance]:
    """Count what is done inside against an allowance."""
    token = _ALLOWANCE.set(allowance)
    try:
        yield allowance
    finally:
        _ALLOWANCE.reset(token)


@contextmanager
def within_part(part: Allowance) -> Iterator[Allowance]:
    """Count what is done inside against a part of the allowance, and then against the whole."""
    whole, before = _ALLOWANCE.get(), part.left
    try:
        with at_most(part):
            yield part
    finally:
        if whole is not None:
            whole.left -= before - max(part.left, 0)


def most_of_what_is_left() -> Allowance:
    """Return a part of the allowance that leaves a tenth of what there is to what comes after.

    >>> with at_most(Allowance(50)):
    ...     most_of_what_is_left().left
    45
    """
    whole = _ALLOWANCE.get()
    return Allowance((MOST_WORK if whole is None else whole.left) * 9 // 10)


def spend(steps: int) -> None:
    """Count steps; raise :class:`WorkLimitError` where the allowance is used up.

    Outside of a compilation nothing is counted.
    """
    allowance = _ALLOWANCE.get()
    if allowance is not None:
        allowance.left -= steps
        if allowance.left < 0:
            raise WorkLimitError


MOST_KEPT_RESULTS = 2048
"""Results that a function keeps at most."""


def kept(function: Callable[P, T]) -> Callable[P, T]:
    """Return a function that keeps its latest results; their work counts each time all the same.

    >>> twice = kept(lambda x: spend(3) or 2 * x)
    >>> with at_most(Allowance(7)) as allowance:
    ...     twice(1), twice(1), allowance.left
    (2, 2, 1)
    """

    @lru_cache(maxsize=MOST_KEPT_RESULTS)
    def worked(*args: P.args, **kwargs: P.kwargs) -> tuple[T, int]:
        with at_most(_ALLOWANCE.get() or Allowance()) as allowance:
            before = allowance.left
            result = function(*args, **kwargs)
            work, allowance.left = before - allowance.left, before
        return result, work

    @wraps(function)
    def counted(*args: P.args, **kwargs: P.kwargs) -> T:
        result, work = worked(*args, **kwargs)  # type: ignore[arg-type]
        spend(work)
        return result

    return counted
