"""The velocity-constraint graph and the plan that solves it.

Promises, which ``promises.broken_promises`` looks after: every point's velocity is a linear form
in the unknown speeds; each unknown is a drive or found by one block, and the plan's blocks come
in an order in which each uses the drives and earlier blocks only; in every motion relations
hold, links keep their lengths, and sliders stay on their guides. Which relations are independent
is decided exactly, in a finite field (``algebra.modular``): no tolerance is in the plan.
"""

from typing import TYPE_CHECKING

if not TYPE_CHECKING:
    from ..base.later import waiting

    SELDOM = {"locked"}
    __getattr__ = waiting(__name__, SELDOM)
