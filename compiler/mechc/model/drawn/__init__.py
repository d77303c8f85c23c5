"""Drawn places: what they give of lengths, angles and directions.

Promises: what is given holds; what a drawing adds to it is a parameter or a formula.
"""

from .geometry import with_drawn as with_drawn
