"""Python: one module that needs only NumPy."""

from typing import TYPE_CHECKING

if not TYPE_CHECKING:
    from ...base.later import waiting

    SELDOM = {"gradient"}
    __getattr__ = waiting(__name__, SELDOM)
