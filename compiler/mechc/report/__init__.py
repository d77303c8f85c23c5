"""What people read: the derivation in steps, sentences in three languages, text and LaTeX.

Promises: nothing is computed here that an earlier stage has not found; every name is
explained once, before or where it is first met.
"""

from typing import TYPE_CHECKING

if not TYPE_CHECKING:
    from ..later import waiting

    SELDOM = {"book_forms", "steps"}
    __getattr__ = waiting(__name__, SELDOM)
