"""The LaTeX target: a report that compiles by itself, or a fragment of it."""

from typing import TYPE_CHECKING

if not TYPE_CHECKING:
    from ...base.later import waiting

    SELDOM = {"pictures"}
    __getattr__ = waiting(__name__, SELDOM)
