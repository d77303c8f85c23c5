"""The geometries of the seeds as descriptions, with friction at their joints."""

import json
import math
from functools import cache
from typing import Any

from paths import SEEDS


@cache
def entries(name: str) -> dict[str, dict[str, Any]]:
    """Return the entries of a file of the seeds by their id."""
    return {e["id"]: e for e in json.loads((SEEDS / name).read_text("utf-8"))}


def described(identifier: str) -> str:
    """Return a friction case as a description, every friction ``shrunk`` times as large."""
    case = entries("friction.json")[identifier]
    geometry = entries("geometries.json")[case["geometry"]]
    values = _values(geometry["params"])
    at = {p: tuple(_number(c, values) for c in xy) for p, xy in geometry["points"].items()}
    shared = [p for p, _ in geometry["sliders"]] if geometry["mirror"] else []
    if geometry["mirror"]:
        axis = 90 if geometry["mirror"].startswith("x") else 0
        shared += [p for p in geometry["ground"] if abs(at[p][0 if axis else 1]) < 1e-12]
    lines = ["param shrunk = 1", *(f"pivot {p}" for p in geometry["ground"])]
    lines += [
        f"slider {p} along {math.atan2(*map(float, d[::-1]))!r} rad" for p, d in geometry["sliders"]
    ]
    for body in map("".join, geometry["bodies"]):
        tail, *heads = _points(body)
        lines.append(f"link {body}")
        for head in heads:
            x, y = (b - a for a, b in zip(at[tail], at[head], strict=True))
            lines.append(f"{tail}{head} = ({x!r} m, {y!r} m)")
    halves = 2 if shared else 1
    loads = [("P", geometry["drive"]), *_loads(geometry, values)]
    lines += [_force(n, load, 1 if load["point"] in shared else halves) for n, load in loads]
    if shared:
        lines.append(f"mirror across {axis} deg sharing {' '.join(dict.fromkeys(shared))}")
    for point, radius in case["friction_circle_radius"].items():
        if any(point in _points("".join(body)) for body in geometry["bodies"]):
            lines.append(f"friction pin {point} 0.1 diameter shrunk*({20 * radius!r} m)")
    for point, factor in case["slider_factor"].items():
        lines.append(f"friction slider {point} shrunk*{factor!r}")
    return "\n".join([*lines, "find k = P / F"])


def _points(name: str) -> list[str]:
    points: list[str] = []
    for letter in name:
        points.append(letter) if letter.isalpha() else points.append(points.pop() + letter)
    return points


def _values(params: dict[str, str]) -> dict[str, float]:
    values: dict[str, float] = {}
    for name, text in params.items():
        values[name] = _number(text, values)
    return values


def _number(text: str, values: dict[str, float]) -> float:
    """Evaluate an expression of the seeds, which are a file of the project."""
    functions = {n: getattr(math, n) for n in ("sin", "cos", "tan", "asin", "sqrt", "pi")}
    return float(eval(text, {"__builtins__": {}}, {**functions, **values}))


def _force(name: str, load: dict[str, Any], halves: int) -> str:
    along = math.atan2(*(float(c) for c in load["dir"][::-1]))
    times = load["mult"] / halves
    return f"force {name} at {load['point']} along {along!r} rad times {times!r}"


def _loads(geometry: dict[str, Any], values: dict[str, float]) -> list[tuple[str, dict[str, Any]]]:
    """Return the output load F; one that acts in two parts is tied to the first of them."""
    parts = []
    for load in geometry["loads"]:
        x, y = (_number(c, values) for c in load["dir"])
        size = math.hypot(x, y)
        parts.append({**load, "dir": (x, y), "mult": load["mult"] * size})
    return [(f"F{i} = F" if i else "F", load) for i, load in enumerate(parts)]
