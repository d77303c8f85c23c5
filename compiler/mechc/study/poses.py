"""Poses to compare formulas at: the default one, then random ones within the ranges.

The draw is seeded, so that two runs see the same poses.
"""

import random
from collections.abc import Iterator
from itertools import islice

from ..model.mechanism import Mechanism
from ..model.values import Chain, Values, allowed, bounds, defaults, dependent, independent

TRIES = 200
"""Draws before a narrow ``require`` is given up."""


def default_pose(mechanism: Mechanism) -> Values:
    """Return the values that the user gave, those that follow from them included.

    A parameter declared by dimension only is missing.
    """
    return complete(mechanism, defaults(mechanism))


def complete(mechanism: Mechanism, given: Values) -> Values:
    """Return the values with the dependent parameters that follow from them."""
    return Chain(dependent(mechanism)).complete(given)


def random_poses(mechanism: Mechanism, number: int, seed: int = 1) -> Iterator[Values]:
    """Yield up to ``number`` poses that every ``require`` allows."""
    chance, chain = random.Random(seed), Chain(dependent(mechanism))
    drawn = (chain.complete(_draw(mechanism, chance)) for _ in range(TRIES))
    return islice((v for v in drawn if allowed(mechanism, v)), number)


def _draw(mechanism: Mechanism, chance: random.Random) -> Values:
    return {p.name: chance.uniform(*bounds(p)) for p in independent(mechanism)}
