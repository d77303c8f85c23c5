"""Two wedges with any friction: jammed, or a force, as all signs of the pressing forces allow.

Wedge W slides along x and lifts follower V along its guide. With the signs of the forces in both
guides given, equilibrium is linear: all four cases together tell whether any force balances.
"""

import math
from itertools import product
from random import Random

import numpy as np
import pytest

import mechc
from sources import in_thirds

WEDGES = """
param alpha = {alpha!r} rad
param gamma = {gamma!r} rad
slide WXY along x
slide UV along 90 deg + gamma
contact U on WX normal 90 deg + alpha
WX = @ alpha
force P at W along -x
force F at V along 270 deg + gamma
friction contact U {face!r}
friction slider W {under!r}
friction slider V {beside!r}
find k = P/F
"""


def unit(angle):
    return np.array([math.cos(angle), math.sin(angle)])


def forces(alpha, gamma, face, under, beside, sense):
    """Return every force P that balances F = 1 as the wedge slides."""
    normal, along, up = unit(alpha + math.pi / 2), unit(alpha), unit(gamma + math.pi / 2)
    rise = math.sin(alpha) / (normal @ up)
    slip = math.copysign(1, sense * (rise * (up @ along) + math.cos(alpha)))
    push = normal - face * slip * along
    found = []
    for a, b in product((1, -1), repeat=2):
        guide = a * unit(gamma + math.pi) - beside * math.copysign(1, sense * rise) * up
        floor = np.array([under * sense, b])
        rows = np.zeros((4, 4))
        rows[:2, 0], rows[:2, 1] = push, guide
        rows[2:, 0], rows[2:, 2], rows[2:, 3] = -push, floor, (-1, 0)
        contact, *sizes, drive = np.linalg.solve(rows, [*up, 0, 0])
        if min(contact, *sizes) >= 0:
            found.append(drive)
    return found


@pytest.mark.parametrize("seed", in_thirds(range(5)))
def test_wedges_jam_where_no_signs_of_forces_balance(seed):
    dice = Random(f"wedges {seed}")
    angles = {
        "alpha": math.radians(dice.uniform(8, 50)),
        "gamma": math.radians(dice.uniform(-30, 30)),
    }
    rough = {
        n: dice.choice((0.1, 0.5, 1, 2, 3)) * dice.uniform(0.5, 1.5)
        for n in ("face", "under", "beside")
    }
    results = mechc.loads(WEDGES.format(**angles, **rough)).results
    for name, sense in (("k_f", 1), ("k_hold", -1)):
        balanced, value = forces(**angles, **rough, sense=sense), results[name].default
        state = results[name].locking.state
        assert (state == "jammed") == (not balanced and sense > 0)
        if value is None:
            assert state != "free"
        if balanced:
            assert value == pytest.approx(min(balanced, key=lambda p: abs(p - value)), rel=1e-9)
            assert (state == "free") == (value > 0)
