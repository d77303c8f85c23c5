"""What counts as zero, equal or straight in a figure: each with its reason.

Two sizes come back. What is compared with itself after a few operations differs by less than
1e-9; a point that was found by an arc cosine near the end of its range has half the digits, 1e-6.
"""

ON_ONE_LINE = 1e-9
"""Three points whose triangle is flatter than this, to its sides, are on one line."""

DEPENDENT = 1e-9
"""An equation whose coefficients are below this follows from the others."""

SAME_LENGTH = 1e-9
"""Lengths that differ by less than this part are equal."""

NO_SPEED = 1e-9
"""A speed below this part of the largest is none."""

SAME_VELOCITY = 1e-6
"""Velocities that differ by less than this part of the largest are equal."""

SAME_PLACE = 1e-6
"""Points nearer to each other than this, in usual lengths, are one: a gap of rounding."""

SAME_ANGLE = 1e-6
"""Angles in radians, or half turns, nearer to each other than this are the same."""

NO_LENGTH = 1e-6
"""A length below this part of the figure is none, and nothing to measure."""

PARALLEL = 1e-6
"""Falls of a rope at an angle of a smaller sine are parallel."""
