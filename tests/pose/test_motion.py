"""Coordinates, directions and their rates, against points found by Newton's method."""

import math

import numpy as np
import pytest

import reference_closed
from mechc.compilation import Compilation, compile_source
from mechc.files import find, read
from mechc.model.values import defaults
from mechc.routine.evaluate import evaluate, pose
from mechc.source import Source
from paths import LIBRARY

CLOSED = ("crank_rocker", "jansen_leg", "oscillating_cylinder", "watt_closed", "triad_closed")
STEP = 1e-4
TURNING = "drive phi from 0 deg to 360 deg"

CRANK_SLIDER = """
mechanism crank_slider
param r = 40 mm
param l = 100 mm
param phi = 50 deg
pivot O at (5 mm, -3 mm)
slider B along x through (0 mm, 10 mm)
link OAC
link AB
OA = r @ phi
angle AOC = 40 deg
OC = 70 mm
AB = l
assembly B forward
drive phi from 0 deg to 360 deg
force P at C along perp OC
force F at B along -x
find k = P/F
"""


def compiled(name: str, speed: str = "") -> Compilation:
    source = read(find(name))
    lines = [f"{t} {speed}" if t.startswith("drive ") else t for t in source.text.splitlines()]
    return compile_source(Source(f"{name}.mech", "\n".join(lines)))


def found_at(compilation: Compilation, drive: float | np.ndarray) -> dict[str, np.ndarray]:
    points = compilation.routine.points
    assert points is not None
    assert compilation.mechanism.drive is not None
    values = {**defaults(compilation.mechanism), compilation.mechanism.drive.parameter: drive}
    return pose(points.program, values)[0]


def assembled(compilation: Compilation, values: dict[str, float]):
    start = reference_closed.places(compilation, values)
    return reference_closed.Assembled(compilation.tree, values, start).assembled()


@pytest.mark.parametrize("name", CLOSED)
def test_places_and_slopes_are_those_of_the_loops_solved_by_coordinates(name: str) -> None:
    compilation = compiled(name)
    assert compilation.mechanism.drive is not None
    drive = compilation.mechanism.drive.parameter
    values = defaults(compilation.mechanism)
    step = STEP * max(abs(values[drive]), 0.1)
    ahead, here, behind = (
        assembled(compilation, {**values, drive: values[drive] + sign * step})
        for sign in (1, 0, -1)
    )
    found, largest = found_at(compilation, values[drive]), 0.0
    for point in here.points:
        slope = (ahead.at(point) - behind.at(point)) / (2 * step)
        for axis, place, change in zip("xy", here.at(point), slope, strict=True):
            assert found[f"{axis}_{point}"] == pytest.approx(place, abs=1e-10)
            stated = found.get(f"d{axis}_{point}_d{drive}", 0.0)
            assert stated == pytest.approx(change, abs=2e-6 * max(1.0, np.max(np.abs(slope))))
            largest = max(largest, abs(change))
    assert largest > 1e-3


@pytest.mark.parametrize("name", CLOSED)
def test_accelerations_are_the_second_differences_of_places(name: str) -> None:
    speed = 12.0 if name != "oscillating_cylinder" else 0.3
    compilation = compiled(name, f"speed {speed} {'rad/s' if speed > 1 else 'm/s'}")
    points = compilation.routine.points
    assert points is not None
    assert compilation.mechanism.drive is not None
    drive = defaults(compilation.mechanism)[compilation.mechanism.drive.parameter]
    time = 2e-4 * max(abs(drive), 0.1) / speed
    behind, here, ahead = (found_at(compilation, drive + speed * time * s) for s in (-1, 0, 1))
    stated = {(q.of, q.axis, q.kind): here[q.name] for q in points.quantities}
    checked = 0
    for q in points.quantities:
        if q.kind == "place":
            first = (ahead[q.name] - behind[q.name]) / (2 * time)
            second = (ahead[q.name] - 2 * here[q.name] + behind[q.name]) / time**2
            for kind, number in (("velocity", first), ("acceleration", second)):
                known = stated.get((q.of, q.axis, kind), 0.0)
                size = max(abs(v) for (_, _, k), v in stated.items() if k == kind)
                assert known == pytest.approx(number, abs=3e-6 * size), (q.name, kind)
                checked += abs(known) > 1e-3 * size
    assert checked >= 4


def test_points_of_a_body_and_of_a_guide_with_a_place() -> None:
    compilation = compile_source(Source("a.mech", CRANK_SLIDER))
    found = found_at(compilation, 2.0)
    a = np.array([5e-3 + 0.04 * math.cos(2.0), -3e-3 + 0.04 * math.sin(2.0)])
    turned = 2.0 + math.radians(40)
    b = a[0] + math.sqrt(0.1**2 - (0.01 - a[1]) ** 2)
    expected = {
        "x_A": a[0],
        "y_A": a[1],
        "x_C": 5e-3 + 0.07 * math.cos(turned),
        "y_C": -3e-3 + 0.07 * math.sin(turned),
        "x_B": b,
        "y_B": 0.01,
        "phi_OA": 2.0,
        "phi_AB": math.atan2(0.01 - a[1], b - a[0]),
    }
    assert {n: found[n] for n in expected} == pytest.approx(expected, abs=1e-15)
    assert found["dy_B_dphi"] == pytest.approx(0, abs=1e-16)
    assert {q.of for q in compilation.motion.quantities} == {*"OABC", "OAC", "AB"}  # type: ignore[union-attr]


def test_a_slot_in_a_place_that_nothing_gives_has_no_coordinates() -> None:
    names = {q.of for q in compiled("crank_shaper").motion.quantities}  # type: ignore[union-attr]
    assert "C" not in names
    assert "B" in names


def test_without_a_drive_nothing_moves() -> None:
    assert compile_source(read(LIBRARY / "karpenko_fig9_packet_clamp.mech")).motion is None


def test_components_of_velocities_are_slopes_of_coordinates() -> None:
    asked = "find x = V_C_x/omega_OAC, y = V_C_y/omega_OAC, u = V_B_x/V_C_x, v = V_C/omega_OAC"
    compilation = compile_source(Source("a.mech", CRANK_SLIDER + asked))
    found = found_at(compilation, 2.0)
    x, y, u, v = (
        evaluate(f, {**defaults(compilation.mechanism), "phi": 2.0})
        for f in compilation.routine.functions[1:]
    )
    assert x == pytest.approx(found["dx_C_dphi"], rel=1e-14)
    assert y == pytest.approx(found["dy_C_dphi"], rel=1e-14)
    assert u == pytest.approx(found["dx_B_dphi"] / found["dx_C_dphi"], rel=1e-14)
    assert v == pytest.approx(math.hypot(x, y), rel=1e-14)
