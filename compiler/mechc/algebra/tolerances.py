"""What counts as zero where algebra looks at numbers: each with its reason.

Its answers are exact, from a finite field or from multiplying out. Numbers only say what is not
worth looking into.
"""

SAME_ANGLE = 1e-12
"""An angle beyond a bound by less than this, in radians, was rounded, and lies within it."""

ROUNDED_SUM = 1e-9
"""A sum below this part of its terms is zero: each of them was rounded a few times."""

DEPENDENT = 1e-9
"""A pivot below this part of a row is rounding: the row follows from the others."""

PLAINLY_NOT_ZERO = 1e-5
"""What is not below this part of a sum's terms is not zero, without looking closer."""

POLE = 1e-5
"""Terms that grow by more than its inverse may have a pole."""
