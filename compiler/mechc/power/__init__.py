"""Virtual power: Σ F·V = 0, solved without friction for what was asked.

Promises, which ``promises.broken_promises`` looks after: every ratio, load, speed and force at a
joint is a formula in free parameters and the names of its ``where``, and has its dimension; the
equations vanish with a ratio for every motion of the plan; a load that is found is the sum of
the others, each by a coefficient without loads in it.
"""

from typing import TYPE_CHECKING

if not TYPE_CHECKING:
    from ..base.later import waiting

    SELDOM = {"force_results", "reactions", "speed_results"}
    __getattr__ = waiting(__name__, SELDOM)
