"""Loads, and friction where bodies touch.

Promises: every load acts on a body that is there; every coefficient has a value that makes sense.
"""

from typing import TYPE_CHECKING

if not TYPE_CHECKING:
    from ...base.later import waiting

    SELDOM = {"collars", "friction", "pulleys"}
    __getattr__ = waiting(__name__, SELDOM)
