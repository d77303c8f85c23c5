"""The stroke: what was asked for along the driving coordinate, and where it is singular.

``from_balance`` makes it, ``stroke`` is it as data. ``run`` is what is looked at and where,
``..sweep`` gives values there by the code of ``..forms``.
``stretches`` are the parts that have a pose and ``ends`` what limits them (those that have none
are found by ``..open_loops``), ``branches`` where closures meet; ``in_step`` and
``points_in_step`` ask whether what is given follows the drive. ``singular`` finds zeros and
poles, ``jumps`` jumps, ``extrema`` the least and the greatest, ``ratio_extent`` all of a ratio,
and ``rounded`` says what of these is rounding. ``rows`` and ``columns`` make the table, with
``transmission`` angles and ``velocities``.

Promises: every row is a pose that can be assembled and that the conditions of use allow, or says
why it is not; singular poses and extrema lie on the stroke, in its order.
"""

from typing import TYPE_CHECKING

if not TYPE_CHECKING:
    from ...base.later import waiting

    SELDOM = {"ratio_extent"}
    __getattr__ = waiting(__name__, SELDOM)
