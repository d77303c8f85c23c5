"""What counts as zero, level or whole on paper: each with its reason.

Points are sums of some dozens of doubles, so that what is one by geometry differs by some 1e-12 of
the figure, or 1e-9 where a loop was closed. Nothing that is drawn on purpose comes near that.
"""

HORIZONTAL = 1e-9
"""A unit vector that rises by less than this is horizontal: the cosine of 90° is 6e-17."""

ON_EDGE = 1e-9
"""A corner that is ahead of an edge by less than this, in millimetres, is on the edge."""

ON_AXIS = 1e-6
"""A point nearer to a line than this, in millimetres, is on it: half the digits hold."""

DETOUR = 1e-6
"""A point is on a line between two others where the way by it is longer by less than this part."""

ALONG_AXIS = 1e-12
"""A line that changes a coordinate by less than this, in millimetres, never crosses its bounds."""

SHORTEST_LINE = 1e-9
"""A line counts as this long at least, in millimetres: one of no length has no direction."""

NO_EXTENT = 1e-9
"""A drawing whose points are all at one place is this part of the figure's size."""

NO_BAR = 1e-6
"""A bar shorter than this part of the figure's size has no length: a gap may leave as much."""

SAME_WHOLE_NUMBER = 1e-9
"""A number nearer to a whole one than this is whole: tenths have no exact double."""

SAME_STEP = 1e-12
"""A step that is too small by no more than this part was rounded, like its power of ten."""

ONE_VALUE = 1e-9
"""A range narrower than this part of its ends is one value, which an axis is widened around."""

ONE = 1e-9
"""A multiple nearer to 1 than this is 1, and not written in front of its unit."""

NO_FORCE = 1e-9
"""A force below this part of the largest is rounding, as a couple is below its moments.

No other one is left out: a screw may turn by a thousandth of what its force has for a moment.
"""
