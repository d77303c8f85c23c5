"""What counts as zero, equal or parallel in what a description gives: each with its reason.

Given values have the digits that the user wrote, and are equal at 1e-9. What follows from them
in a few operations is exact to a dozen digits, 1e-12.
"""

SAME_VALUE = 1e-9
"""Values of a description that differ by less than this part are equal."""

VANISHED = 1e-12
"""A value below this, in SI or against its like, is a zero that was rounded."""

SAME_DIRECTION = 1e-9
"""Directions in radians that differ by less, or from 90° by less, are parallel, or square."""

SAME_PLACE = 1e-9
"""Points nearer to one another than this part of the drawing are one."""

SAME_VECTOR = 1e-11
"""Vectors of numbers at a smaller angle, in radians, are parallel, and of such lengths equal."""

DEPENDENT = 1e-7
"""What is left of a row of derivatives below this part is rounding: the row follows from others."""
