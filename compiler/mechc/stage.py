"""A stage of a compilation: run once, when it is first asked for, within a limit of work."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Generic, Protocol, TypeVar, overload

from .diagnostics import Report
from .diagnostics import syntax_limits as messages
from .source import Span
from .work import MOST_WORK, Allowance, WorkLimitError, at_most

T = TypeVar("T")


class Limited(Protocol):
    """What has stages: something with a report, and an allowance that they share."""

    report: Report
    allowance: Allowance


class Stage(Generic[T]):
    """A method whose value is kept, like ``functools.cached_property``, and counted."""

    def __init__(self, run: Callable[..., T]) -> None:
        self._run = run
        self.__doc__ = run.__doc__

    def __set_name__(self, owner: type, name: str) -> None:
        self._name = name

    def kept(self, compilation: Limited) -> T | None:
        """Return the value where the stage has run, None where it has not."""
        value: T | None = vars(compilation).get(self._name)
        return value

    @overload
    def __get__(self, compilation: None, owner: type) -> "Stage[T]": ...

    @overload
    def __get__(self, compilation: Limited, owner: type) -> T: ...

    def __get__(self, compilation: Limited | None, owner: type) -> "T | Stage[T]":
        """Return the value; the instance's dictionary hides this descriptor from then on."""
        if compilation is None:
            return self
        with within(compilation.allowance, compilation.report):
            value = self._run(compilation)
        compilation.__dict__[self._name] = value
        return value


@contextmanager
def within(allowance: Allowance, report: Report) -> Iterator[None]:
    """Count what is done inside; end it with E817 where it is more than is allowed."""
    try:
        with at_most(allowance):
            yield
    except WorkLimitError:
        raise report.fail(messages.too_much_work(Span(0, 0), MOST_WORK)) from None
