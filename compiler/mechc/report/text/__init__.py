"""Reports as plain text for the terminal."""

from typing import TYPE_CHECKING

if not TYPE_CHECKING:
    from ...base.later import waiting

    SELDOM = {"note", "overview", "printer"}
    __getattr__ = waiting(__name__, SELDOM)
