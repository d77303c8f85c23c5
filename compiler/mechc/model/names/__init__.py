"""What a description names: points and the links through them, parameters, loads, results.

Promises: a name means one thing, and what formulas may not use is refused where it stands.
"""

from typing import TYPE_CHECKING

if not TYPE_CHECKING:
    from ...base.later import waiting

    SELDOM = {"not_brought"}
    __getattr__ = waiting(__name__, SELDOM)
