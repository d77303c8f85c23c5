"""Closed mechanisms along their strokes, against the loops solved by coordinates.

The reference differences the work of the loads, so that it knows nothing of velocities
either; what it leaves open is the error of a central difference.
"""

import math

import pytest

import mechc
import reference_closed
from good_mechanisms import ALL, CLOSED, PARTS, compiled, tree_of
from mechc.formula.evaluate import evaluate
from mechc.model.mechanism import LoadRatio
from mechc.power.numbers import value_of
from sources import in_thirds


def values_at(name, part):
    mechanism = compiled(name).pose.mechanism
    drive = mechanism.drive
    low, high = (evaluate(end, {}) for end in (drive.low, drive.high))
    values = {
        p.name: evaluate(p.value, {}) for p in mechanism.parameters if p.value and not p.dependent
    }
    return {**values, drive.parameter: low + (high - low) * part}


@pytest.mark.parametrize("name", in_thirds(CLOSED))
def test_k_along_the_stroke(name):
    compilation, tree = compiled(name), tree_of(name)
    result = next(r for r in compilation.solution.results if isinstance(r.target, LoadRatio))
    for part in PARTS:
        values = values_at(name, part)
        expected = reference_closed.ratio(
            compilation, tree, values, result.target.above, result.target.below
        )
        assert value_of(result, values) == pytest.approx(expected, rel=1e-6)


@pytest.mark.parametrize("name", [*CLOSED, "claw_closed"])
def test_the_derivative_is_total(name):
    """dk/dφ along the stroke, against a difference of k itself."""
    compilation = compiled(name)
    result = next(r for r in compilation.results if isinstance(r.target, LoadRatio))
    drive = compilation.pose.mechanism.drive.parameter
    slope = result.derivatives[drive]
    for part in PARTS:
        values = values_at(name, part)
        step = 1e-5 * max(abs(values[drive]), 0.1)
        ahead, behind = (
            value_of(result, {**values, drive: values[drive] + s * step}) for s in (1, -1)
        )
        full = dict(values)
        for definition in compilation.pose.definitions:
            full[definition.name] = evaluate(definition.formula, full)
        scale = abs(ahead) / max(abs(values[drive]), 0.1)
        assert evaluate(slope, full) == pytest.approx(
            (ahead - behind) / (2 * step), rel=1e-6, abs=1e-6 * scale
        )


def test_the_place_of_a_slider_under_a_name_of_ones_own():
    """s = r cos φ + sqrt(l² − r² sin² φ), and k = r sin(φ + β)/cos β with sin β = r/l sin φ."""
    text = """
param r = 50 mm
param l = 150 mm
param phi = 40 deg
param s: length
pivot O at (0 mm, 0 mm)
slider B along x through O
link OA
link AB
OA = r @ phi
AB = l
OB = s @ 0 deg
assembly B forward
drive phi from 0 deg to 360 deg
torque M on OA
force F at B along x
find k = M/F
let lead = s - l
"""
    found = mechc.loads(text, "named.mech").evaluate()
    phi = math.radians(40)
    beta = math.asin(math.sin(phi) / 3)
    lead = 0.05 * math.cos(phi) + 0.15 * math.cos(beta) - 0.15
    assert float(found["lead"]) == pytest.approx(lead, rel=1e-12)
    assert float(found["k"]) == pytest.approx(0.05 * math.sin(phi + beta) / math.cos(beta))


def test_a_ternary_link_given_by_its_three_sides():
    """The side CD says what the angle at B says; a body's own triangle closes no loop."""
    text = ALL["triad_closed"].read_text(encoding="utf-8")
    sides = text.replace("angle CBD = 60 deg", "CD = 80 mm\nassembly CBD cw")
    given = mechc.loads(text, "a.mech"), mechc.loads(sides, "b.mech")
    phi = [0.6, 0.9, 1.3]
    one, other = (g.evaluate(phi=phi)["k"] for g in given)
    assert other == pytest.approx(one, rel=1e-12)
