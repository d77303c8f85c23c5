"""The stroke: what was asked for along the driving coordinate, and where it is singular.

Promises: every row is a pose that can be assembled and that the conditions of use allow,
or says why it is not; singular poses and extrema lie on the stroke, in its order.
"""

from typing import TYPE_CHECKING

if not TYPE_CHECKING:
    from ...later import waiting

    SELDOM = {"extent"}
    __getattr__ = waiting(__name__, SELDOM)
