"""The free bodies as pictures show them: each balances, and what one gives another gets back."""

import math
from collections.abc import Iterator, Mapping
from typing import NamedTuple

from mechc.compilation import Compilation
from mechc.pose.places import Plane
from mechc.statics.diagrams.diagram import Acting, Diagram, FreeBody

BALANCED = 1e-7
"""What sums may come to, as a part of the largest force and moment of all bodies together."""

CENTRE = Plane(0.013, -0.007)
"""A place about which moments are taken; none of a mechanism is there."""


def refuted(compilation: Compilation) -> Iterator[str]:
    """Yield the bodies that do not balance, and the joints that pass on two different forces."""
    figure = compilation.figure
    if figure is None:
        return
    for diagram in compilation.free_bodies:
        case = f"{diagram.result} {diagram.motion}".strip()
        sizes = _sizes(diagram, figure.points)
        for body in diagram.bodies:
            yield from (f"{case}: {said}" for said in _out_of_balance(body, figure.points, sizes))
        yield from (f"{case}: {said}" for said in _one_sided(diagram, sizes))
        yield from (f"{case}: {said}" for said in _loads(diagram, compilation))


class Sizes(NamedTuple):
    """The largest force and the largest moment in a diagram: beside them others are rounding."""

    force: float
    moment: float


def _sizes(diagram: Diagram, places: Mapping[str, Plane]) -> Sizes:
    acting = [a for body in diagram.bodies for a in body.forces if not a.gap]
    forces = (math.hypot(*a.force) for a in acting if a.force)
    moments = (abs(a.about(CENTRE, places)) for a in acting)
    return Sizes(max(forces, default=0.0), max(moments, default=0.0))


def _out_of_balance(body: FreeBody, places: Mapping[str, Plane], sizes: Sizes) -> Iterator[str]:
    """Yield the sums of forces, and of moments, that are not zero."""
    if any(acting.gap for acting in body.forces):
        return
    known = [acting for acting in body.forces if acting.force is not None]
    x = math.fsum(a.force.x for a in known if a.force)
    y = math.fsum(a.force.y for a in known if a.force)
    moments = [a.about(CENTRE, places) for a in body.forces]
    if math.hypot(x, y) > BALANCED * sizes.force:
        yield f"the forces on {body.name} come to ({x:.3g}, {y:.3g})"
    if abs(math.fsum(moments)) > BALANCED * sizes.moment:
        yield f"the moments on {body.name} come to {math.fsum(moments):.3g}"


def _one_sided(diagram: Diagram, sizes: Sizes) -> Iterator[str]:
    """Yield the pins at which two bodies do not give one another the same force."""
    found = {
        (b.name, a.by, a.point): a for b in diagram.bodies for a in b.forces if a.kind == "pin"
    }
    for (body, by, point), here in found.items():
        there = found.get((by, body, point))
        if there is not None and body < by and not _are_opposite(here, there, sizes):
            yield f"{body} and {by} give one another at {point} {here.force} and {there.force}"


def _are_opposite(here: Acting, there: Acting, sizes: Sizes) -> bool:
    if here.force is None or there.force is None:
        return here.force is there.force
    gap = math.hypot(here.force.x + there.force.x, here.force.y + there.force.y)
    turn = abs(here.moment + there.moment)
    return gap <= BALANCED * sizes.force and turn <= BALANCED * sizes.moment


def _loads(diagram: Diagram, compilation: Compilation) -> Iterator[str]:
    """Yield the loads that act in another size than a result has it."""
    (result,) = (r for r in compilation.results if r.name == diagram.result)
    suffix = {"tightening": "_f", "releasing": "_f", "": ""}[diagram.motion]
    found = next((r for r in compilation.results if r.name == f"{result.name}{suffix}"), None)
    above = getattr(result.target, "above", None)
    if found is None or found.default is None or not math.isfinite(found.default):
        return
    if diagram.per and above in diagram.loads and not diagram.trouble:
        size = diagram.loads[above] / diagram.loads[diagram.per]
        if not math.isclose(size, found.default, rel_tol=1e-6, abs_tol=1e-9):
            yield f"{above} is {size} for {diagram.per} = 1, and {found.name} is {found.default}"
