"""Closed mechanisms that were refused once, or of which a loop was forgotten: k by coordinates.

Redundant bars and guides, coordinates that pass zero, one dimension too many, a term that
vanishes at the drawn pose, a loop that k does not rest on.
"""

from functools import cache

import numpy as np
import pytest

import mechc
import reference_closed
import reference_geometry
from mechc.compilation import Compilation, complete
from mechc.routine.evaluate import evaluate, pose
from mechc.source import Source
from mechc.statics.geometry_check import worst_gap
from paths import CORPUS

CLOSED = CORPUS / "closed"
NAMES = sorted(path.stem for path in CLOSED.iterdir())

REMARKED = {
    "loop_not_needed": {"W594"},
    "slider_on_either_side": {"W594"},
    "triangle_sides_and_angle": {"W594"},
    "trammel_on_two_guides": {"W301", "W401"},
    "trammel_redundant_crank": {"W401"},
}
"""Warnings that a mechanism is there for."""


def text_of(name: str) -> str:
    return (CLOSED / f"{name}.mech").read_text(encoding="utf-8")


@cache
def compiled(name: str) -> Compilation:
    return complete(Compilation(Source(f"{name}.mech", text_of(name))))


@pytest.mark.parametrize("name", NAMES)
def test_warnings(name: str) -> None:
    codes = {d.code for d in compiled(name).report.diagnostics} - {"W502"}
    assert codes == REMARKED.get(name, set())


@pytest.mark.parametrize("move", [0.0, 0.01])
@pytest.mark.parametrize("name", [name for name in NAMES if name != "pin_on_two_lines"])
def test_k_by_coordinates(name: str, move: float) -> None:
    compilation = compiled(name)
    (function,) = compilation.routine.functions
    values = dict(reference_geometry.defaults(compilation.tree))
    (moving,) = [n for n in values if n in ("phi", "psi", "x")]
    values[moving] += move
    find = compilation.mechanism.finds[0].target
    expected = _ratio(compilation, values, moving, find.above, find.below)
    found = evaluate(function, values)
    assert found == pytest.approx(expected, rel=1e-6, abs=1e-7)


def _ratio(compilation, values, moving, above, below):
    """Return above/below by the work of both in a small step of what moves."""
    start = reference_closed.places(compilation, values)
    poses = {
        sign: reference_closed.Assembled(
            compilation.tree, {**values, moving: values[moving] + sign * 1e-5}, start
        ).assembled()
        for sign in (-1, 0, 1)
    }
    work = {n: reference_closed._work(n, compilation.tree, poses) for n in (above, below)}
    return -work[below] / work[above]


def test_a_pin_on_two_lines_needs_no_drive():
    (finding,) = compiled("pin_on_two_lines").findings
    assert finding.outcome in ("proved", "agrees")


def test_a_loop_that_k_does_not_rest_on():
    """The slot's loop does not close between 1.4723 and 1.7781; the loops of k do."""
    routine = compiled("loop_not_needed").routine
    (function,) = routine.functions
    phi = np.array([1.46, 1.49, 1.6, 1.77, 1.79])
    k = evaluate(function, {"phi": phi, "r": 0.05})
    assert np.isfinite(k).tolist() == [True, False, False, False, True]
    _, status = pose(routine.pose, {"phi": phi, "r": 0.05})
    assert status.tolist() == [0, 1, 1, 1, 0]


def test_a_slider_on_either_side_stands_as_described():
    """The crank's pivot lies on the guide: the loop closes before it and behind it."""
    compilation = compiled("slider_on_either_side")
    for x in (0.3, 0.5, -0.3, -0.5):
        figure = compilation.drawn({"x": x})
        assert worst_gap(compilation.pose, figure.values) is None


def test_no_loop_closes_without_a_place_said_once():
    text = text_of("slot_crank_at_zero").replace("pivot Q at (5 m, 0 m)", "pivot Q")
    with pytest.raises(mechc.MechcError) as caught:
        mechc.loads(text)
    assert [d.code for d in caught.value.diagnostics] == ["E312"]
