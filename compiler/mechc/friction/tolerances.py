"""What counts as equal or standing where friction is found: each with its reason."""

SAME_BY_ITERATION = 1e-6
"""By how much two numbers may differ that are one by algebra; iteration gives some of them."""

PRECISE = 1e-9
"""What a bound of rounding may be at most where it says that something is zero."""

ACUTE_MARGIN = 1e-9
"""How far an acute angle is from 0° and 90° at least, in radians: its tangent is finite."""

NEAR_POSE = 1e-8
"""How far from the default pose the sides of a result are looked at, in SI."""

AWAY_FROM_POSE = 1e-3
"""How far from the default pose signs are looked at, in radians: far enough for no rounding."""

STAYS_ZERO = 1e-9
"""What is below this so far from the default pose, in SI, is zero there, too."""
