"""Friction: the surfaces that slide, the forces that press them, and k with both.

In order: ``slips``, ``friction_pairs``, ``normal_forces``, then a closed form body after body
(``sequential``) or for guides alone (``linear``), else the ``coupled`` equations (``iterated``).
What a coefficient, a law and lengths make of a joint's factor is read in
``..model.forces.friction``.

Promises, which ``promises.broken_promises`` looks after: friction takes its power from the drive;
a result whose signs follow from the pose is printed for the default pose, where both are one
number; every name, in guards and conditions too, is defined, and means one thing in all results.
"""

from typing import TYPE_CHECKING

if not TYPE_CHECKING:
    from ..base.later import waiting

    SELDOM = {"at_rest", "closed_forces", "joint_forces", "linear", "problem", "results"}
    __getattr__ = waiting(__name__, SELDOM)
