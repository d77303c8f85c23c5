"""Regular expressions that are compiled when they are first used.

What is imported has some fifty, of which a compilation uses a few; to compile the rest takes
a thirtieth of its time.
"""

from __future__ import annotations

import re

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


class _Pattern:
    """Stands for a compiled regular expression, and compiles it when it is asked for a method."""

    def __init__(self, expression: str, flags: int) -> None:
        self._given = (expression, flags)

    def __getattr__(self, name: str) -> Any:
        method = getattr(re.compile(*self._given), name)
        setattr(self, name, method)  # found without this function from now on
        return method


def pattern(expression: str, flags: int = 0) -> re.Pattern[str]:
    """Return a regular expression, to be compiled with its first use.

    >>> word = pattern("[a-z]+", re.IGNORECASE)
    >>> word.findall("crank OA"), word.fullmatch("rod")[0]
    (['crank', 'OA'], 'rod')
    """
    made: Any = _Pattern(expression, flags)
    return made  # type: ignore[no-any-return]
