"""What counts as zero or equal in results of virtual power: each with its reason.

Results are compared where every value is of order one.
"""

VANISHED = 1e-12
"""Below this a value of order one is a zero that was rounded, and has no sign."""

SAME_RESULT = 1e-9
"""By how much two numbers may differ that are one by algebra."""

SAME_IN_OTHER_UNITS = 1e-6
"""By what part they may differ where units were changed: iteration ends at half the digits."""
