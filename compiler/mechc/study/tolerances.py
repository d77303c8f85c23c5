"""What counts as zero, equal or one value where a result is studied: each with its reason.

Three sizes come back. A value that is narrowed down is exact to some thirteen digits, so that
values are one at 1e-9 of the stroke. What is near a branch point comes from angles of a
triangle that is nearly flat, and a difference quotient from two values that are nearly equal:
both have half the digits, 1e-6. What only rounding makes of a zero is 1e-12 of what is usual.
"""

EXACT, NEARLY = 1e-13, 1e-10
"""Widths, against the size of what is looked at, to which an end is narrowed down."""

SAME_VALUE = 1e-9
"""Places closer than this part of the range are one; k with a zero and a pole is undetermined."""

VANISHED_SUM = 1e-9
"""A sum is zero below this part of its size a radian away."""

SAME_ZERO = 1e-6
"""A factor is zero at a place where it is smaller, as a part of its largest value on the stroke."""

SAME_TURN = 1e-6
"""Extrema closer than this part of the range are one: of a flat top half the digits are known."""

SAME_RATIO = 1e-9
"""Relative difference below which two formulas agree at a pose."""

PRINTED_ROUNDING = 1e-6
"""What a printed formula may be off its value, as a part: iteration finds half the digits."""

SAME_FIGURE = 1e-12
"""What reading a figure may round off, as a part of it: a tolerance holds at its very end."""

SAME_EFFICIENCY = 1e-9
"""An efficiency that varies by less is constant, and one that dips by less has no minimum."""

NEGLIGIBLE = 1e-3
"""A ratio below this part of the usual one, or above it over this, may be but rounding.

Equal links that lie on one another unfold at 90 degrees: rounding leaves a thousandth of what is
usual, where there is nothing, some 1e-7 radians before that.
"""

TOUCHED = 1e-6
"""A ratio that comes nearer to zero than this, against its value next to it, touches it."""

JUMP_WIDTH = 1e-6
"""The width of a jump, where a sign changes, against the distance in the grid."""

NARROW_RANGE = 1e-9
"""A range of a parameter narrower than this, against its size, is not halved again."""

SMALLEST = 1e-300
"""What a width is relative to where both ends of a range are zero."""

HALF_THE_DIGITS = 1e-7
"""An interval narrower than this part of all that is looked at may be but rounding.

Where links lie on one another, angles have half their digits, and k has either sign.
"""

VANISHED_MARGIN = 1e-12
"""A margin below this part of its greatest value is zero; twice what rounding makes of one."""

TOUCHING_WIDTH = 1e-8
"""How exact a value is where a margin touches zero, as a part of the stroke.

A minimum is known to half the digits.
"""

BRANCH_POINT = 1e-6
"""Zeros and poles closer to a branch point than this part of the stroke lie on it.

Angles of a triangle that is nearly flat have half the digits.
"""

NEAR_BRANCH_POINT = 1e-4
"""Nearer to a branch point than this part of the stroke an angle is off by more than k changes.

A cosine next to 1 that is off by a rounding e is that of an angle x off by e/x, and k by e/x².
"""

AT_BRANCH_POINT = 1e-3 * BRANCH_POINT
"""A value this near to a branch point is that point: every loop counts as flat there."""

CROSSING = 1e-12
"""How exact a value is at which branches cross that are found by iteration."""

STRAIGHT = 1e-12
"""A transmission angle below this, in radians, is 0 but for rounding."""

FLAT_LOOP = 1e-6
"""A part of the stroke that is narrower is a pose in which a loop lies flat, rounded."""

CONSTANT = 1e-11
"""What changes by less from one value to the next, as a part of its usual size, is constant."""

LOST = 1e-6
"""What rounding may leave of a zero, as a part of what is usual."""

SIDE = 1e-9
"""The part of the stroke from a value at which its sides are looked at."""

JUMP_SIDES = (1e-9, 1e-8)
"""The parts of the stroke from a jump at which is seen what grows without end towards it."""

ACROSS = 1e-3
"""The part of a stroke from a place where a formula is 0/0 at which a result is right again.

Rounding is left there in the thirteenth figure, and so is what a cubic is off in between.
"""

SMOOTH = 1e-2
"""What a cubic may be off between its places, as a part of what it changes by: more is a kink."""

NEAR_END = 0.01
"""The part of a cell from an end of a part at which a turn before that end shows."""

NEAR_JAM = (0.01, 0.1, 0.23, 0.47)
"""The parts of a cell from a jam at which a result is looked at: it may turn twice there."""

NEAR_ZERO = 1e-7
"""The part of a stroke by which a simple zero is left, at the least: values are beyond rounding."""

NOTHING_AT_END = 1e-3
"""What a factor is at an end where it is nothing, at most, as a part of what it is next to it.

It goes to zero there as a root: 1e-3 is left at :data:`DIFFERENCE`, 1e-8 of rounding at the end.
"""

VANISHING = 1e-3
"""What is left at a value, against half the distance, of what vanishes there, at most."""

SAME_SIDES = 1e-6
"""By what part two sides may differ, and a value between them lie beyond one, by rounding."""

NEARBY = (1e-7, 1e-6, 1e-5, 1e-4)
"""The parts of the stroke from a value at which its order is seen, the nearest that does first.

Farther away another zero or pole, so near as 1e-6 of the stroke, hides it; nearer, rounding.
"""

BEYOND_BRANCH_POINT = (2e-5, 1e-4)
"""The same at a branch point: a sixteenth of each is still farther than what lies on that."""

SAME_EXPONENT, VARYING_EXPONENT = 0.1, 0.3
"""What two exponents of one power may differ by, and which is none of a constant.

Exponents are whole, or halves where a loop folds: 0.3 is nearer to 1/2 than to 0.
"""

STEADY = 1e-3
"""What a function that is finite changes by from one side of a value to the other, at most."""

DIFFERENCE = 1e-6
"""The part of a radian, a metre or a stretch by which the drive is moved to see what changes.

A difference quotient is best where rounding and curvature cost the same, at half the digits.
"""

STILL = 1e-12
"""A velocity below this part of the speeds that it is the sum of is none."""

SAME_RATE = 1e-5
"""Rates that differ by less than this part are equal: differences lose half the digits."""

STEP_BACK = 1e-3
"""The part of the stroke by which one goes back before the curve is followed."""

LEAST_LENGTH = 1e-3
"""A length counts as this long at least, in metres, when steps are measured by it."""

SHOWN_JUMP = 1e-6
"""The part of a value by which it jumps if that shows in the six figures that are printed."""

BEFORE_JUMP = 1e-2
"""How far before a jump an efficiency is looked at, as a part of the cell that ends there."""

THREE_FIGURES = 1e-4
"""What an efficiency may still change by where its least or greatest is: three figures are said.

Where it has a kink, it takes more sections.
"""

VANISHES_TOO = 1e-6
"""What a factor may be at a zero of another one that it vanishes with."""

FROM_ROOT = (1e-4, 1e-6)
"""How far from a root the values are compared that refute it, in radians.

Far from it rounding does no harm; near it no other root that is close by does.
"""

SAME_FACTOR = 1e-3
"""What a figure may be off where only its sign or its unit is wrong."""
