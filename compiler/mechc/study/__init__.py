"""What follows from the results: zeros and poles, trends, locking, efficiency, the stroke.

Promises: what is said without "sampled" is proved; nothing here changes a formula.
"""

from typing import TYPE_CHECKING

if not TYPE_CHECKING:
    from ..base.later import waiting

    SELDOM = {"locking", "ratios"}
    __getattr__ = waiting(__name__, SELDOM)
