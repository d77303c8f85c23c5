"""Formulas in numbers: code for many values, rounding errors, zeros, and solutions of systems.

``straight_line`` puts formulas in order as code, ``rounding`` bounds the errors of one value and
``rounded_columns`` those of many. ``roots`` finds zeros and turning points of a function of the
drive, ``jumps`` where it is broken. ``elimination`` solves linear equations; by ``newton`` the
solutions of other systems are followed, by ``arcs`` along their branch, by ``continuation`` for
all values of one symbol, and ``folds`` are where such a branch turns back.
"""

from typing import TYPE_CHECKING

if not TYPE_CHECKING:
    from ...base.later import waiting

    SELDOM = {"arcs", "continuation", "newton", "roots", "rounded_columns"}
    __getattr__ = waiting(__name__, SELDOM)
