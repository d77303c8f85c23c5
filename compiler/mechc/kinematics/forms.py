"""Linear forms in the unknown speeds: projections of velocities, spins of links."""

from collections.abc import Iterable, Mapping
from typing import assert_never

from ..algebra.angle import QUARTER, Angle
from ..algebra.product import ONE, Product
from ..algebra.sums import add
from ..algebra.trigonometry import cosine
from ..model.mechanism import Force, ForcePair, Load, Torque
from ..pose.pose import PointContact, Pose, Vector
from .graph import Flow, Graph, LinearForm, Velocity


def turned(vector: Vector, spin: int) -> Velocity:
    """Return the velocity that a spin gives to the head of a vector whose tail is at rest."""
    return tuple(Flow(length, angle + QUARTER, spin) for length, angle in vector)


def projection(velocity: Velocity, direction: Angle) -> LinearForm:
    """Return the component of a velocity along a direction."""
    terms: dict[int, list[Product]] = {}
    for size, heading, unknown in velocity:
        terms.setdefault(unknown, []).append(size * cosine(heading - direction))
    return _collected(terms)


def subtract(left: LinearForm, right: LinearForm) -> LinearForm:
    """Return the difference of two forms."""
    terms = {u: [p] for u, p in left.items()}
    for u, p in right.items():
        terms.setdefault(u, []).append(-p)
    return _collected(terms)


def combined(parts: Iterable[tuple[Product, LinearForm]]) -> LinearForm:
    """Return the sum of forms, each times a factor."""
    terms: dict[int, list[Product]] = {}
    for factor, form in parts:
        for u, p in form.items():
            terms.setdefault(u, []).append(factor * p)
    return _collected(terms)


def parting(graph: Graph, pair: ForcePair, line: Angle) -> LinearForm:
    """Return the rate at which the points of a pair part along a line.

    Across the mirror it is the first point's part in it, half of the whole.
    """
    if pair.joins_twins:
        return projection(graph.velocities[pair.first], line)
    ahead, behind = (projection(graph.velocities[p], line) for p in (pair.second, pair.first))
    return subtract(ahead, behind)


def speed_of_load(graph: Graph, load: Load) -> LinearForm:
    """Return the speed with which a load does its work: its power is the load times this."""
    match load:
        case Force(name, point):
            return projection(graph.velocities[point], graph.pose.lines[name])
        case ForcePair(name):
            return parting(graph, load, graph.pose.lines[name])
        case Torque(_, link):
            return spin(graph, link)
        case _:
            assert_never(load)


def relative_speed(graph: Graph, contact: PointContact, along: Angle) -> LinearForm:
    """Return the component of a pin's velocity relative to the body that it touches."""
    own, under = (projection(graph.velocities[p], along) for p in (contact.point, contact.tail))
    form = subtract(own, under)
    if not contact.reach:
        return form
    lever = add(arm.length * cosine(arm.angle + QUARTER - along) for arm in contact.reach)
    return subtract(form, scaled(spin(graph, contact.body), lever))


def scaled(form: LinearForm, factor: Product) -> LinearForm:
    """Return a form times a factor."""
    return {u: p * factor for u, p in form.items()}


def _collected(terms: Mapping[int, Iterable[Product]]) -> LinearForm:
    sums = {u: add(parts) for u, parts in terms.items()}
    return {u: p for u, p in sums.items() if p}


def spin(graph: Graph, link: str) -> LinearForm:
    """Return the angular velocity of a link, counter-clockwise.

    A rod has no unknown of its own: ω = (V_B − V_A)·n / AB, with n the rod's direction
    turned by +90°.
    """
    if link in graph.spins:
        return {graph.spins[link]: ONE}
    tail, head = list(graph.pose.frames[link])[:2]
    return rod_spin(graph.pose, link, tail, head, graph.velocities)


def rod_spin(
    pose: Pose, link: str, tail: str, head: str, velocities: Mapping[str, Velocity]
) -> LinearForm:
    """Return the angular velocity of a link from the velocities of two of its points."""
    arms = pose.vector(link, tail, head)
    normal = arms[0].angle + QUARTER
    difference = subtract(
        projection(velocities[head], normal), projection(velocities[tail], normal)
    )
    reach = add(a.length * cosine(a.angle - arms[0].angle) for a in arms)
    return scaled(difference, reach**-1)
