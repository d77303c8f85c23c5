"""The length of a spring, whatever the line between its ends is found by."""

import math

import pytest

import mechc

ACROSS_TWO_EQUAL_ARMS = """
param a = 60 mm
param phi = 120 deg in 115 deg .. 125 deg
pivot O at (0 mm, 0 mm)
pivot Q at (a, 0 mm)
link OA
OA = a @ phi
spring 3 N/mm between Q and A free 60 mm
torque M on OA
find M
"""


def test_a_spring_across_two_equal_arms_has_the_length_that_halves_their_angle():
    found = mechc.loads(ACROSS_TWO_EQUAL_ARMS).evaluate()
    length, arm = 0.12 * math.sin(math.radians(60)), 0.06 * math.cos(math.radians(60))
    assert found["M"] == pytest.approx(3000 * (length - 0.06) * arm)
