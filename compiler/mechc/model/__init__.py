"""The mechanism as a value: names resolved, units turned into SI, dimensions checked.

Promises: every name in every formula is declared; definitions have no cycle; every
formula has one dimension; every point of a joint, load or guide stands on a body, a
pivot or a slider; at least one find or let is asked for.
"""

from typing import TYPE_CHECKING

if not TYPE_CHECKING:
    from ..base.later import waiting

    SELDOM = {"drawn", "equivalent_rods", "translations"}
    __getattr__ = waiting(__name__, SELDOM)
