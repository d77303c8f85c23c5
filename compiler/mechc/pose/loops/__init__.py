"""Loops closed: sought directions and places found from lengths and the drive.

Promises: what is found is a definition of the pose, or a sum of named angles put in for
it; each uses only parameters and earlier definitions.
"""

from typing import TYPE_CHECKING

if not TYPE_CHECKING:
    from ...later import waiting

    SELDOM = {"branches", "by_groups", "state"}
    __getattr__ = waiting(__name__, SELDOM)
