"""What is asked for: results, reactions, conditions of use, what books expect, the report.

Promises: whatever is named there is a quantity of the mechanism or of the description.
"""

from typing import TYPE_CHECKING

if not TYPE_CHECKING:
    from ...base.later import waiting

    SELDOM = {"failures", "reported"}
    __getattr__ = waiting(__name__, SELDOM)
