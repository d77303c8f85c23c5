"""The figure: where every point is at a pose, and what is drawn there.

Whoever draws needs nothing but the figure: no angle algebra, no parameters, no second half
to be made up.
"""
