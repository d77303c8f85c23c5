"""How an iteration of Newton's method ends: solved, where its branch ends, or not at all."""

from typing import Literal

NewtonStatus = Literal[0, 1, 2]

SOLVED: Literal[0] = 0
BRANCH_ENDS: Literal[1] = 1
"""The branch ends on the way: there is no solution beyond."""

NOT_FOUND: Literal[2] = 2
"""Corrections ran out: neither was found."""
