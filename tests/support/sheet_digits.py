"""How many digits of a library sheet may rest on the last one of a sine, and where more do.

Sines and arcs of NumPy, of one C library and of another differ by a unit in the last place.
What comes out of a sheet differs by a few, but where something in it comes to zero.
"""

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from mechc.compilation import Compilation
from mechc.emit.python.to_python import TARGET as PYTHON
from mechc.emit.target import Options
from mechc.files import library, mechanisms
from paths import EXAMPLES
from run_targets import ULP, companions

POINTS = 400

FEW = 8
"""Units in the last place."""

SHEETS = {name: library()[name] for name in sorted(library().keys() - mechanisms().keys())}
SHEETS |= {"examples/gripper": EXAMPLES / "gripper" / "gripper.mech"}
SHEETS |= {"examples/pin": EXAMPLES / "pin.mech"}

NEAR_ZERO = {
    "centring": {"x": "the part is at the pivots", "x_0": "so it is", "beta_0": "levers in line"},
    "claw_angles": {
        **dict.fromkeys(("eta", "gamma"), "a rod as long as its crank is in line with it"),
        **dict.fromkeys(("N", "k", "k_lift"), "such a rod stands across at 90 deg"),
        **dict.fromkeys(("delta", "e", "epsilon"), "the contact is at D"),
    },
    "prism_jaws": dict.fromkeys(
        ["P_1", "P_3", "P_c", "dP_far", "dP_near", "P_p1", "P_p2", "P_p3", "P_p4", "P_p"],
        "inertia lifts the part",
    ),
}
"""Results that come to zero, or rest on what does, within the ranges.

The last digit of an input moves them by more: they are held against that.
"""

BALANCES = {"prism_jaws": ("R_x", "R_y")}
"""What is zero by itself, and is held against the forces that balance."""

Call = Callable[..., np.ndarray]

Values = Sequence[np.ndarray]


def by_python(found: Compilation, numpy: Any = np) -> tuple[list[Call], Call | None]:
    """Return the functions of the emitted module in order, and that of the status, if any."""
    (module,) = PYTHON.emit(found, Options("module"))
    space: dict[str, Any] = {"__name__": "module"}
    exec(compile(module.text, "module.py", "exec"), space)
    space["np"] = numpy
    made = [n for n, v in space.items() if getattr(v, "__module__", "") == "module"]
    beside = ("_", "pose", "points", *companions(found))
    return [space[n] for n in made if not n.startswith(beside)], space.get("status")


def within(found: Compilation, margin: float = 0.0) -> dict[str, np.ndarray]:
    """Return the values of all parameters, then random ones in their ranges, or a part beyond.

    Where a parameter has no range they are about its value.
    """
    random, drawn = np.random.default_rng(7), dict[str, np.ndarray]()
    for item in (i for f in found.routine.functions for i in f.inputs):
        middle = 1.0 if item.default is None else item.default
        low = 0.6 * middle if item.low is None else item.low
        high = 1.5 * middle if item.high is None else item.high
        beyond = margin * ((high - low) or 2.0)
        values = random.uniform(*sorted((low - beyond, high + beyond)), POINTS)
        values[0] = middle
        drawn.setdefault(item.name, values)
    return drawn


def most(sheet: str, result: str, call: Call, values: Values, forces: np.ndarray) -> np.ndarray:
    """Return by how much a result may differ between targets; ``forces`` are those of a balance."""
    size = np.abs(np.broadcast_to(call(*values), POINTS))
    if result in BALANCES.get(sheet, ()):
        size = forces
    elif result in NEAR_ZERO.get(sheet, {}):
        size = size + moved_by_rounding(call, values)
    return FEW * ULP * size


def moved_by_rounding(call: Call, values: Values) -> np.ndarray:
    """Return by how much a result moves where each input moves by its own size, to first order."""
    step, moves = 1e-7, np.zeros(POINTS)
    for i, value in enumerate(values):
        ends = (call(*values[:i], value * by, *values[i + 1 :]) for by in (1 + step, 1 - step))
        up, down = ends
        moves = moves + np.nan_to_num(np.abs(up - down) / (2 * step))
    return moves
