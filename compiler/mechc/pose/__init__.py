"""Which directions are given and which follow; loops closed.

Promises, which ``promises.broken_promises`` looks after: every pair of points of a link has a
vector, every guide and force a direction; definitions mention parameters and earlier ones only,
and no symbol is undefined; bodies meet at the default pose; rates are how definitions change
with the drive.
"""

from typing import TYPE_CHECKING

if not TYPE_CHECKING:
    from ..base.later import waiting

    SELDOM = {"assembly_checks", "force_pairs"}
    __getattr__ = waiting(__name__, SELDOM)
