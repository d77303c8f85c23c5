"""Formulas as people read them: the tree that is handed out, and what is done with it.

``tree``: the nodes and their builders. ``walk``: the names in a formula. ``evaluate``: its value;
``numeric``: all else that is done with numbers. ``operations``: its length. ``layout`` and
``names``: how it is set; ``typesetting``: the walk over it that the terminal and LaTeX share.
``to_text``, ``to_sympy``: the ways out that belong to no target.
"""

from typing import TYPE_CHECKING

if not TYPE_CHECKING:
    from ..base.later import waiting

    SELDOM = {"derivative"}
    __getattr__ = waiting(__name__, SELDOM)
