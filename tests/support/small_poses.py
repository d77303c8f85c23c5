"""Small linkages as poses built by hand, in letters, for tests that need no earlier stage."""

import math
from fractions import Fraction

from mechc.algebra.angle import Angle
from mechc.algebra.product import Product
from mechc.diagnostics import Report
from mechc.formula.tree import ZERO, Symbol, number
from mechc.kinematics.carriers import graph_of
from mechc.kinematics.graph import Graph
from mechc.kinematics.plan import Plan
from mechc.kinematics.planning import plan_of
from mechc.model import mechanism as model
from mechc.pose.pose import Arm, PointContact, Pose, PoseDefinition, Vector
from mechc.source import Source, Span
from mechc.units import ANGLE, LENGTH

HERE = Span(0, 1)
ALONG = model.Absolute(ZERO, HERE)

LENGTHS = {"a": 0.3, "b": 0.2, "r": 0.04, "l": 0.11, "c": 0.05}
ANGLES = {"alpha": 0.4, "phi": 0.7, "psi": -0.3, "theta": 1.1}
VALUES = {**LENGTHS, **ANGLES}


def at(degrees=0, **terms):
    """Return an angle: ``at(90, phi=1)`` is phi + 90°."""
    return sum((Angle.of(n) * c for n, c in terms.items()), Angle.constant(Fraction(degrees)))


def arm(length, angle) -> Vector:
    return (Arm(Product.symbol(length), angle),)


def parameter(name, dimension, value):
    return model.Parameter(name, dimension, HERE, number(Fraction(value)))


PARAMETERS = (
    *(parameter(n, LENGTH, v) for n, v in LENGTHS.items()),
    *(parameter(n, ANGLE, v) for n, v in ANGLES.items()),
)


def force(name, point, **more):
    return model.Force(name, point, ALONG, HERE, **more)


def torque(name, link, **more):
    return model.Torque(name, link, HERE, **more)


def pose(frames, *, pivots=(), guides=(), joints=(), loads=(), lines=(), slides=(), **more) -> Pose:
    """Return a pose: links by their frames, directions by the names of points and loads."""
    guides, lines, slides = dict(guides), dict(lines), dict(slides)
    own = {n: more.pop(n) for n in ("mirror", "drive", "friction", "finds") if n in more}
    mechanism = model.Mechanism(
        name="by_hand",
        title="",
        source="",
        span=HERE,
        parameters=PARAMETERS,
        links=tuple(model.Link(n, tuple(f), HERE) for n, f in frames.items() if n not in slides),
        slides=tuple(model.Slide(n, tuple(frames[n]), ALONG, HERE) for n in slides),
        joints=(
            *(model.Pivot(p, HERE) for p in pivots),
            *(model.Slider(p, ALONG, HERE) for p in guides),
            *joints,
        ),
        loads=tuple(loads),
        **own,
    )
    return Pose(
        mechanism,
        frames,
        guides,
        lines,
        more.pop("axis", None),
        tuple(PoseDefinition(*d) for d in more.pop("definitions", ())),
        {},
        tuple(p.name for p in PARAMETERS),
        slides=slides,
        **more,
    )


def lever(**more) -> Pose:
    """A lever on O: A is a ahead along alpha, B is b to its left."""
    frame = {"O": (), "A": arm("a", at(alpha=1)), "B": arm("b", at(90, alpha=1))}
    loads = (force("P", "A"), force("F", "B"))
    lines = {"P": at(90, alpha=1), "F": at(alpha=1)}
    return pose({"OAB": frame}, pivots="O", loads=loads, lines=lines, **more)


def slider_crank(**more) -> Pose:
    """A crank r at phi, a rod l at psi to a slider B along x; the torque M turns the crank."""
    frames = {
        "OA": {"O": (), "A": arm("r", at(phi=1))},
        "AB": {"A": (), "B": arm("l", at(psi=1))},
    }
    loads = (torque("M", "OA"), force("F", "B"))
    return pose(frames, pivots="O", guides={"B": at()}, loads=loads, lines={"F": at()}, **more)


def two_bars(**more) -> Pose:
    """A toggle: bars OB and BK, each l long and alpha off the vertical guide of K."""
    frames = {
        "OB": {"O": (), "B": arm("l", at(90, alpha=1))},
        "BK": {"B": (), "K": arm("l", at(90, alpha=-1))},
    }
    loads = (force("P", "B"), force("F", "K"))
    lines = {"P": at(0), "F": at(-90)}
    return pose(frames, pivots="O", guides={"K": at(90)}, loads=loads, lines=lines, **more)


def on_pivots(*joints, **more) -> Pose:
    """Two cranks, OA and QB, on pivots of their own, and what joins them."""
    frames = {
        "OA": {"O": (), "A": arm("a", at(phi=1))},
        "QB": {"Q": (), "B": arm("b", at(theta=1))},
    }
    loads = (torque("M", "OA"), torque("T", "QB"))
    radii = {Symbol(n): Product.symbol(n) for n in LENGTHS}
    return pose(frames, pivots="OQ", joints=joints, loads=loads, radii=radii, **more)


def wheels(kind="gear", same=False) -> model.WheelPair:
    return model.WheelPair(kind, "O", "OA", Symbol("r"), "Q", "QB", Symbol("c"), same, HERE)


def driven_slider(joint, **more) -> Pose:
    """A crank OA and a slider K along y that a rack or a screw moves."""
    frames = {"OA": {"O": (), "A": arm("a", at(phi=1))}}
    radii = {Symbol(n): Product.symbol(n) for n in LENGTHS}
    loads = (torque("M", "OA"), force("F", "K"))
    return pose(
        frames,
        pivots="O",
        guides={"K": at(90)},
        joints=[joint],
        loads=loads,
        lines={"F": at(-90)},
        radii=radii,
        **more,
    )


RACK = model.Rack("K", "O", "OA", Symbol("r"), HERE)
SCREW = model.Screw("K", Symbol("c"), "OA", HERE)


def slotted() -> Pose:
    """The pin A of the crank OA in a slot of the crank QB, which points at it along theta."""
    touch = PointContact("slot", "A", "QB", "Q", arm("l", at(theta=1)), at(90, theta=1), HERE)
    return on_pivots(model.Slot("A", "QB", "Q", "B", HERE), contacts=(touch,))


def graph(of: Pose) -> Graph:
    return graph_of(of)


def plan(of: Pose) -> Plan:
    return plan_of(graph(of), Report(Source("", "")))


def unknown(of: Graph, name: str) -> int:
    """Return the place of the unknown of a link or a point."""
    return next(i for i, u in enumerate(of.unknowns) if u.of == name)


def number_of(value: Product, **values) -> float:
    return value.evaluate({**VALUES, **values})


def form(found, **values) -> dict[int, float]:
    """Return a linear form in numbers."""
    return {u: number_of(p, **values) for u, p in found.items()}


def size(vector: Vector) -> complex:
    """Return a vector as a complex number."""
    turned = ((number_of(a.length), a.angle.evaluate(VALUES)) for a in vector)
    return sum((s * complex(math.cos(t), math.sin(t)) for s, t in turned), 0j)
