"""Equilibrium of every free body: the second opinion on k.

It shares the mechanism and its pose with virtual power and nothing else. ``unfold`` puts
the whole mechanism into numbers, ``equations`` cuts it into links and pins and writes
their sums of forces and moments, ``sparse_elimination`` solves them, ``answers`` and
``speeds`` ask for one ratio, and the ``referee`` compares at several ``poses``, after
``geometry_check`` has measured whether the mechanism stands there as described. ``diagrams`` hand
out what acts on every body, for reports and pictures, as ``all_forces`` finds it.
"""

from typing import TYPE_CHECKING

if not TYPE_CHECKING:
    from ..base.later import waiting

    SELDOM = {"counted", "friction_loads", "joint_forces", "speeds", "surfaces"}
    __getattr__ = waiting(__name__, SELDOM)
