"""What wheels alone lead in a drawn mechanism, against finite differences of its places."""

import cmath
import math
from collections.abc import Callable

import pytest

from mechc.driver import Compilation
from mechc.routine.evaluate import evaluate
from mechc.source import Source

STEP = 1e-6

CRANK = """
mechanism geared
pivot O at (0 mm, 0 mm)
link OA
A at (30 mm, 20 mm)
force P at A along -x
force F at B along y
find k = P/F
"""

PAIRS = {
    "gear O 20 mm, C 50 mm": -0.4,
    "gear C 50 mm, O 20 mm": -0.4,
    "gear O 20 mm, C 50 mm inner": 0.4,
    "belt O 20 mm, C 50 mm": 0.4,
    "belt O 20 mm, C 50 mm crossed": -0.4,
}

LEVER = "pivot C at (70 mm, 0 mm)\nlink CB\nB at (90 mm, 30 mm)\n"
START = math.atan2(20, 30)
"""The drawn direction of the crank."""


def crank(phi: float) -> complex:
    """Return where the crank's pin A is."""
    return abs(0.03 + 0.02j) * cmath.rect(1, phi)


def lever(turn: float) -> complex:
    """Return where B is after a turn of CB."""
    return 0.07 + (0.02 + 0.03j) * cmath.rect(1, turn)


def holds(text: str, drive: str, places: Callable[[float], tuple[complex, complex]], *at: float):
    """Assert that k balances P and F in the motion that the places make, all along a stroke."""
    (function,) = Compilation(Source("geared.mech", text)).routine.functions
    inputs = {i.name: i.default for i in function.inputs}
    for place in at:
        (a0, b0), (a1, b1) = places(place - STEP), places(place + STEP)
        expected = (b1 - b0).imag / (a1 - a0).real
        assert evaluate(function, {**inputs, drive: place}) == pytest.approx(expected, rel=1e-6)


@pytest.mark.parametrize("pair", PAIRS)
def test_a_link_follows_the_wheels_from_where_it_is_drawn(pair: str):
    text = f"{CRANK}{LEVER}{pair}\ndrive OA from 10 deg to 80 deg"
    ratio = PAIRS[pair]
    holds(text, "phi_OA", lambda x: (crank(x), lever(ratio * (x - START))), 0.2, START, 1.3)


def test_a_stroke_beyond_a_full_turn_begins_where_it_is_drawn():
    text = f"{CRANK}{LEVER}gear O 20 mm, C 50 mm\ndrive OA from 370 deg to 440 deg"
    drawn = START + math.tau
    holds(text, "phi_OA", lambda x: (crank(x), lever(-0.4 * (x - drawn))), 6.6, drawn, 7.5)


def test_a_train_of_wheels_is_followed_through_an_idler():
    idler = "pivot D at (46 mm, 32 mm)\nlink DE\nE at (46 mm, 42 mm)\n"
    train = "gear D 10 mm, C 30 mm\nbelt O 20 mm, D 10 mm\n"
    text = f"{CRANK}{LEVER}{idler}{train}drive OA from 10 deg to 80 deg"
    holds(text, "phi_OA", lambda x: (crank(x), lever(-2 / 3 * (x - START))), 0.2, START, 1.3)


def rocker(k: complex) -> complex:
    """Return where KB = 90.55 mm and CB = 70.71 mm meet, B to the left of the way from K to C."""
    pin, near, far = 0.15 + 0.06j, abs(0.08 - 0.04j), abs(0.06 + 0.06j)
    way = pin - k
    along = (abs(way) ** 2 + near**2 - far**2) / (2 * abs(way))
    return k + way / abs(way) * complex(along, -math.sqrt(near**2 - along**2))


@pytest.mark.parametrize("turned", [0, 90, 30])
def test_a_slider_follows_its_pinion_and_leads_a_loop(turned: int):
    unit = cmath.rect(1, math.radians(turned))
    text = f"""{CRANK}
pivot C at (150 mm, 60 mm)
slider K along {turned} deg
link KB
link CB
K at (10 mm, 40 mm)
B at (90 mm, 0 mm)
rack K on O 20 mm
drive OA from 30 deg to 60 deg"""
    holds(
        text,
        "phi_OA",
        lambda x: (crank(x), rocker(0.01 + 0.04j + 0.02 * (x - START) * unit)),
        *(0.53, START, 1.0),
    )


def test_a_pinion_follows_a_slider_that_drives():
    text = """
mechanism geared
param s = 10 mm
pivot O at (0 mm, 0 mm)
pivot Q at (0 mm, -20 mm)
slider K along x through Q
link OB
B at (30 mm, 20 mm)
K at (10 mm, -20 mm)
QK = (s, 0 mm)
rack K on O 20 mm
force P at K along -x
force F at B along y
drive s from 0 mm to 30 mm
find k = P/F"""
    places = lambda s: (s + 0j, (0.03 + 0.02j) * cmath.rect(1, (s - 0.01) / 0.02))  # noqa: E731
    holds(text, "s", places, 0.002, 0.01, 0.025)
