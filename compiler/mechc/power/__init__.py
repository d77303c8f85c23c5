"""Virtual power: Σ F·V = 0, solved without friction for what was asked.

Promises: every ratio, load, speed and force at a joint is a formula in free parameters and
the names of its ``where``; the equations vanish with it for every motion of the plan.
"""
