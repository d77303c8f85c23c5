"""The gates on the errors of many random mechanisms."""

import math

EPS = 2.0**-52

LARGEST_ERROR = 1e4
"""The gate on an error in units of condition · eps."""

USUAL_ERROR = 1e-11
"""The gate on all but one in a thousand."""


def check(errors, conditions):
    """Hold the errors against the gates, and print the worst."""
    scaled = [e / (c * EPS) for e, c in zip(errors, conditions, strict=True)]
    ordered = sorted(errors)
    usual = ordered[min(len(ordered) - 1, math.ceil(0.999 * len(ordered)) - 1)]
    print(f"{len(errors)} mechanisms: median {ordered[len(ordered) // 2]:.1e}, ", end="")
    print(f"p99.9 {usual:.1e}, worst {ordered[-1]:.1e}, {max(scaled):.2g} condition·eps")
    assert max(scaled) < LARGEST_ERROR
    assert usual < USUAL_ERROR
