"""What counts as zero, closed or equal where a pose is found: each with its reason.

Values that are given have the digits that the user wrote, so that data which say one thing
twice are compared at 1e-9. What is drawn, or comes from an arc cosine near the end of its
range, has half the digits of a number: 1e-6.
"""

FLAT_TRIANGLE = 1e-9
"""A triangle whose height is below this part of its longest side has no turn."""

LOOP_GAP = 1e-9
"""A gap below this part of the longest arm counts as closed at the values given."""

SOLVED_GAP = 1e-13
"""A gap below this part of the largest arm is closed, where Newton's method closes it."""

SAME_ANGLE = 1e-9
"""Angles in radians that differ by less at every pose looked at are the same angle."""

SAME_PLACE = 1e-9
"""Places that differ by less than this part are one."""

SAME_CLOSURE = 1e-6
"""Closures whose unknowns differ by less are one: near a dead centre half the digits hold."""

SAME_DIRECTION = 1e-6
"""Directions in radians that differ by less are one: they may come from arc cosines."""

EQUALLY_NEAR = 1e-6
"""Closures whose gaps differ by less than this part of the drawing's size are equally near."""

DRAWN_GAP = 1e-6
"""A gap below this part of the drawing is one of rounding."""

CENTRE_GAP = 1e-6
"""Centres that are off by less than this part of their distance are where they should be."""
