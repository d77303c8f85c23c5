"""The velocity-constraint graph and the plan that solves it.

Promises: every point's velocity is a linear form in the unknown speeds; relations are
homogeneous; the plan's blocks come in an order in which each uses the drives and
earlier blocks only, and each block's determinant does not vanish identically.
"""
