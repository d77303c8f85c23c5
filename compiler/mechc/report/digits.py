"""With how many significant digits reports have numbers."""

VALUE_DIGITS = 6
"""Those of values, of numbers put into formulas, of constants of the user's; text and LaTeX."""

EXTREME_DIGITS = 5
"""Those of the least and the greatest value over a range."""
