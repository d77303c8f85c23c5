"""Modules that are imported, and regular expressions that are compiled, when first needed.

A description that is right needs no words for errors, and they are a tenth of what a
compilation imports; one whose directions are given closes no loops. A package whose modules may
wait has a ``__getattr__`` of :func:`waiting`, which gives them as :class:`Later`;
``from package import module`` then imports nothing.

What is imported has some fifty regular expressions, of which a compilation uses a few; to
compile the rest takes a thirtieth of its time (:func:`pattern`).
"""

from __future__ import annotations

from importlib import import_module

TYPE_CHECKING = False
if TYPE_CHECKING:
    import re
    from collections.abc import Callable, Set
    from typing import Any


class Later:
    """Stands for a module, and imports it when one of its names is asked for, or set.

    >>> module = Later("mechc.version")
    >>> module.VERSION == import_module("mechc.version").VERSION
    True
    """

    def __init__(self, name: str) -> None:
        object.__setattr__(self, "__name__", name)

    def __getattr__(self, name: str) -> Any:
        return getattr(import_module(self.__name__), name)

    def __setattr__(self, name: str, value: Any) -> None:
        setattr(import_module(self.__name__), name, value)

    def __delattr__(self, name: str) -> None:
        delattr(import_module(self.__name__), name)


def waiting(package: str, modules: Set[str]) -> Callable[[str], Later]:
    """Return the ``__getattr__`` of a package some of whose modules wait.

    >>> waiting("mechc", {"version"})("version").VERSION == Later("mechc.version").VERSION
    True
    """

    def attribute(name: str) -> Later:
        if name not in modules:
            raise AttributeError(f"module {package!r} has no attribute {name!r}")
        return Later(f"{package}.{name}")

    return attribute


class _Pattern:
    """Stands for a compiled regular expression, and compiles it when it is asked for a method."""

    def __init__(self, expression: str, flags: int) -> None:
        self._given = (expression, flags)

    def __getattr__(self, name: str) -> Any:
        method = getattr(import_module("re").compile(*self._given), name)
        setattr(self, name, method)  # found without this function from now on
        return method


def pattern(expression: str, flags: int = 0) -> re.Pattern[str]:
    """Return a regular expression, to be compiled with its first use.

    >>> import re
    >>> word = pattern("[a-z]+", re.IGNORECASE)
    >>> word.findall("crank OA"), word.fullmatch("rod")[0]
    (['crank', 'OA'], 'rod')
    """
    made: Any = _Pattern(expression, flags)
    return made  # type: ignore[no-any-return]
