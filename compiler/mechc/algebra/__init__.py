"""Angle algebra: results as products of lengths, sines and cosines, never expanded.

``angle``: rational combinations of symbols plus a constant. ``factors``, ``product``,
``trigonometry``: factored products of lengths, sines, cosines and sums. ``sums``: their
canonical sums. In powers of exp(iα), ``laurent``, all but two terms of sin a cos b + cos a sin b
cancel, and ``factoring`` makes one sine of them; ``pairing`` is the way back, to products again.
``cancelling`` takes out what is on both sides of a line, by ``common_divisors`` and
``sine_divisors``. ``modular``, ``equality``: exact answers at random points of a finite field;
``matrices``: ranks by them, and determinants. ``solution_order``: the order in which relations are
solved, for loops and for velocities.
"""

from typing import TYPE_CHECKING

if not TYPE_CHECKING:
    from ..base.later import waiting

    SELDOM = {"common_divisors", "factoring", "laurent", "pairing", "sine_divisors"}
    __getattr__ = waiting(__name__, SELDOM)
