"""C99: a header and a source, one function and one loop for each result."""

from typing import TYPE_CHECKING

if not TYPE_CHECKING:
    from ...base.later import waiting

    SELDOM = {"gradient", "threads"}
    __getattr__ = waiting(__name__, SELDOM)
