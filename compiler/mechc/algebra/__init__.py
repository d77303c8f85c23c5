"""Angle algebra: results as products of lengths, sines and cosines, never expanded.

``angle``: rational combinations of symbols plus a constant. ``factors``, ``product``,
``trigonometry``: factored products of lengths, sines, cosines and sums. ``sums``: their
canonical sums, by way of ``laurent``, ``factoring`` and ``reduction``. ``modular``,
``equality``, ``rank``: exact answers at random points of a finite field.
"""

from typing import TYPE_CHECKING

if not TYPE_CHECKING:
    from ..later import waiting

    SELDOM = {"factoring", "halving", "laurent", "pairing", "reduction"}
    __getattr__ = waiting(__name__, SELDOM)
