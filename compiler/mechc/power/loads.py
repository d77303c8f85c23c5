"""Loads as terms of the power equations."""

from collections.abc import Sequence
from fractions import Fraction

from ..algebra.angle import rational
from ..algebra.from_formula import to_product
from ..algebra.product import ONE, Product
from ..formula.tree import Formula, Number
from ..formula.walk import substitute, symbols
from ..kinematics.forms import speed_of_load
from ..kinematics.plan import Plan
from ..model.mechanism import Force, Link, Load, Mechanism, PinFriction, Slide, Torque
from .balance import Term


def terms(plan: Plan) -> tuple[Term, ...]:
    """Return the term of every load, in declared order."""
    mechanism = plan.graph.pose.mechanism
    names = {load.name for load in mechanism.loads}
    return tuple(_term(plan, load, names) for load in mechanism.loads)


def _term(plan: Plan, load: Load, names: set[str]) -> Term:
    count = Product(rational(load.times * occurrences(plan.graph.pose.mechanism, load)))
    tie = _tie(load.tie, names) if load.tie is not None else None
    speed = plan.value(speed_of_load(plan.graph, load))
    return Term(load, count, speed, plan.graph.pose.lines.get(load.name), tie)


def given_size(mechanism: Mechanism, load: str) -> Formula | None:
    """Return the value of a known load: a weight, or one that a let defines; None for others."""
    for let in mechanism.lets:
        if let.name == load:
            return let.value
    return next(k.tie for k in mechanism.loads if k.name == load)


def _tie(formula: Formula, names: set[str]) -> tuple[str, Product] | None:
    """Split ``f*R`` into the load R and the factor f; None for a known load (a weight)."""
    for name in sorted(symbols(formula) & names):
        return name, to_product(substitute(formula, {name: Number(Fraction(1))}))
    return None


def shares(mechanism: Mechanism, owner: str) -> tuple[tuple[Product, Load], ...]:
    """Return a free load and those tied to it, each by how much of it a unit of the first means."""
    owned = owners(mechanism)
    found = []
    for load in mechanism.loads:
        name, part = owned[load.name]
        if name == owner:
            often = Product(rational(load.times * occurrences(mechanism, load)))
            found.append((often * part, load))
    return tuple(found)


def owners(mechanism: Mechanism) -> dict[str, tuple[str, Product]]:
    """Return the load that each one is tied to in the end, and how much of it a unit means."""
    names = {load.name for load in mechanism.loads}
    ties = {k.name: _tie(k.tie, names) if k.tie is not None else None for k in mechanism.loads}
    found = {}
    for load in mechanism.loads:
        name, part = load.name, ONE
        while (tie := ties[name]) is not None:
            name, part = tie[0], part * tie[1]
        found[load.name] = name, part
    return found


def occurrences(mechanism: Mechanism, load: Load) -> Fraction:
    """Return how often a load acts: once on what is shared, else on each half or branch."""
    return mechanism.repeats(mechanism.link(load.host).points if load.host else load.points)


def at_rest(load: Load, mechanism: Mechanism) -> str:
    """Return the reason that a load does no work, '' where it may be the direction of a force.

    A couple without work acts on a link that does not turn.
    """
    match load:
        case Torque(link=link):
            return f"link {link} does not turn"
        case Force(point=point, link="") if bearing := _bearing(point, mechanism):
            return f"{point} stands still, and is pressed by what acts `at {point} on {bearing}`"
        case Force(point=point) if point in mechanism.fixed:
            return f"{point} stands still"
        case _:
            return _between(load.points, mechanism)


def _bearing(point: str, mechanism: Mechanism) -> str:
    """Return the link that turns with friction on a point of the ground, '' where none does."""
    pins = (k for k in mechanism.friction.joints if isinstance(k, PinFriction))
    is_one = point in mechanism.fixed and any(pin.point == point for pin in pins)
    return next(iter(mechanism.turning_at(point)), "") if is_one else ""


def _between(points: Sequence[str], mechanism: Mechanism) -> str:
    """Return that the ends of a pair of forces are points of one body, '' where they are not."""
    if len(points) == 2 and mechanism.fixed >= {*points}:
        return f"{' and '.join(points)} stand still"
    bodies: tuple[Link | Slide, ...] = (*mechanism.links, *mechanism.slides)
    name = next((body.name for body in bodies if {*points} <= {*body.points}), "")
    is_within = len(points) == 2 and name
    return f"{' and '.join(points)} are points of one body, {name}" if is_within else ""


def held_drives(mechanism: Mechanism) -> str:
    """Return the drives that are held, as a message names them; '' where there are none."""
    return ", ".join("".join(d.ends) if d.ends else d.parameter for d in mechanism.held)
