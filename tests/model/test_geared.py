"""What wheels alone lead in a drawn mechanism, against finite differences of its places."""

import cmath
import math
from collections.abc import Callable

import pytest

from mechc.compilation import Compilation
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
    "belt O 16 mm, C 40 mm": 0.4,
    "belt O 16 mm, C 40 mm crossed": -0.4,
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


@pytest.mark.parametrize(("inner", "ratio"), [("", 1 + 2.5), (" inner", 1 - 2.5)])
def test_a_planet_follows_its_arm(inner: str, ratio: float):
    """The sun at O is fast in the ground; the planet CB turns on the arm OAC."""
    text = f"""{CRANK.replace("link OA", "link OAC")}
link CB
C at (0 mm, 70 mm)
B at (20 mm, 100 mm)
gear O 50 mm on ground, C 20 mm on CB{inner}
drive OA from 10 deg to 80 deg"""

    def places(x: float) -> tuple[complex, complex]:
        centre = 0.07j * cmath.rect(1, x - START)
        return crank(x), centre + (0.02 + 0.03j) * cmath.rect(1, ratio * (x - START))

    holds(text, "phi_OA", places, 0.3, START, 1.0)


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


@pytest.mark.parametrize("first", ["OA = @ phi\n", "CB = @ 45 deg + phi*20/50\n"])
def test_a_drive_without_a_value_may_stand_in_two_directions(first: str):
    lines = {"OA = @ phi\n", "CB = @ 45 deg + phi*20/50\n"} - {first}
    text = f"{CRANK}param phi: angle\n{LEVER}gear O 20 mm, C 50 mm inner\n{first}{lines.pop()}"
    far, turned = abs(0.02 + 0.03j), math.radians(45)
    holds(
        f"{text}drive phi from 0 deg to 60 deg",
        "phi",
        lambda x: (crank(x), 0.07 + cmath.rect(far, turned + 0.4 * x)),
        *(0.2, 0.6, 1.0),
    )


def test_a_direction_that_a_loop_gives_may_stand_in_another_direction():
    text = f"""{CRANK}
pivot Q at (100 mm, 0 mm)
pivot C at (170 mm, 0 mm)
link AE
link QE
link CB
E at (110 mm, 60 mm)
B at (200 mm, 20 mm)
param psi: angle
CB = @ 30 deg - 20/50*(psi - 80 deg)
QE = @ psi
gear Q 20 mm, C 50 mm
drive OA from -40 deg to 80 deg"""

    def places(x: float) -> tuple[complex, complex]:
        way, near, far = 0.1 - crank(x), abs(0.08 + 0.04j), abs(0.01 + 0.06j)
        along = (abs(way) ** 2 + near**2 - far**2) / (2 * abs(way))
        joint = crank(x) + way / abs(way) * complex(along, math.sqrt(near**2 - along**2))
        turn = cmath.phase(joint - 0.1) - math.radians(80)
        return crank(x), 0.17 + cmath.rect(abs(0.03 + 0.02j), math.radians(30) - 0.4 * turn)

    holds(text, "phi_OA", places, -0.6, -0.1, 0.6, START, 1.2)
