"""The two notations and the one tree between them.

Promises: every node has the span of its text; sums and products are flat; nesting is
at most 64; numbers have at most 40 digits; function names are canonical (``tan`` for
``tg``); a construct of the language either stands in the tree or was reported.
"""

from typing import TYPE_CHECKING

if not TYPE_CHECKING:
    from ..base.later import waiting

    SELDOM = {"examples", "moved", "text"}
    __getattr__ = waiting(__name__, SELDOM)
