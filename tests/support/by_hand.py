"""Poses and results from coordinates, for tests that need no earlier stage."""

import json
import math
from fractions import Fraction

from mechc.algebra.angle import Angle
from mechc.algebra.product import Product
from mechc.formula import tree as formula
from mechc.model import mechanism as model
from mechc.model.result import Result
from mechc.pose.pose import Arm, Pose
from mechc.source import Span
from mechc.units import NUMBER
from paths import SEEDS

HERE = Span(0, 1)


def arm(vector):
    x, y = vector
    if not (x or y):
        return ()
    return (Arm(Product(Fraction(math.hypot(x, y))), at(math.degrees(math.atan2(y, x)))),)


def at(degrees):
    return Angle.constant(Fraction(degrees))


def force(name, point, times=1, tie=None):
    along = model.Absolute(formula.ZERO, HERE)
    return model.Force(name, point, along, HERE, tie, Fraction(times))


def torque(name, link, times=1):
    return model.Torque(name, link, HERE, None, Fraction(times))


def build(points, bodies, pivots, guides, loads, lines, **more):
    """Return a Pose at coordinates; guides and lines in degrees, loads as model loads."""
    links = tuple(model.Link("".join(b), tuple(b), HERE) for b in bodies)
    along = model.Absolute(formula.ZERO, HERE)
    mirror, copies, axis = (more.pop(name, None) for name in ("mirror", "copies", "axis"))
    mechanism = model.Mechanism(
        name=more.pop("name", "by_hand"),
        title="",
        source="",
        span=HERE,
        joints=(
            *(model.Pivot(p, HERE) for p in pivots),
            *more.pop("sliders", [model.Slider(p, along, HERE) for p in guides]),
        ),
        links=links,
        loads=tuple(loads),
        mirror=model.Mirror(along, tuple(mirror), HERE) if mirror is not None else None,
        copies=model.Copies(Fraction(copies[0]), tuple(copies[1]), HERE) if copies else None,
        **more,
    )
    frames = {link.name: _frame(link.points, points) for link in links}
    return Pose(
        mechanism,
        frames,
        {p: at(d) for p, d in guides.items()},
        {name: at(d) for name, d in lines.items()},
        None if axis is None else at(axis),
        (),
        {},
        (),
    )


def _frame(names, points):
    x, y = points[names[0]]
    return {n: arm((points[n][0] - x, points[n][1] - y)) for n in names}


def result(name, target, value, **more):
    """Return a Result with a number for a formula, given to the last bit."""
    return Result(name, target, NUMBER, formula.number(Fraction(value)), **more)


def geometries():
    return json.loads((SEEDS / "geometries.json").read_text())


def in_numbers(geometry):
    """Return a geometry's points, directions and k as numbers."""
    names = {n: getattr(math, n) for n in ("sin", "cos", "tan", "asin", "acos", "sqrt", "pi")}
    for name, text in geometry["params"].items():
        names[name] = eval(text, {}, names)

    def value(text):
        return eval(text, {}, names)

    points = {n: (value(x), value(y)) for n, (x, y) in geometry["points"].items()}
    return points, value, value(geometry["k"])


def angle_of(pair, value):
    x, y = (value(t) for t in pair)
    return math.degrees(math.atan2(y, x)), math.hypot(x, y)
