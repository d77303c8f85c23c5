"""The free bodies as pictures show them: each balances, and what one gives another gets back."""

import math
from collections.abc import Iterator, Mapping

from mechc.driver import Compilation
from mechc.pose.places import Plane
from mechc.statics.diagram import Acting, Diagram, FreeBody

BALANCED = 1e-7
"""What the sums on a body may come to, by the largest force on it and how far it is off."""

CENTRE = Plane(0.013, -0.007)
"""A place about which moments are taken; none of a mechanism is there."""


def refuted(compilation: Compilation) -> Iterator[str]:
    """Yield the bodies that do not balance, and the joints that pass on two different forces."""
    figure = compilation.figure
    if figure is None:
        return
    for diagram in compilation.free_bodies:
        case = f"{diagram.result} {diagram.motion}".strip()
        for body in diagram.bodies:
            yield from (f"{case}: {said}" for said in _out_of_balance(body, figure.points))
        yield from (f"{case}: {said}" for said in _one_sided(diagram))
        yield from (f"{case}: {said}" for said in _loads(diagram, compilation))


def _out_of_balance(body: FreeBody, places: Mapping[str, Plane]) -> Iterator[str]:
    """Yield the sums of forces, and of moments, that are not zero."""
    if any(acting.gap for acting in body.forces):
        return
    known = [acting for acting in body.forces if acting.force is not None]
    x = math.fsum(a.force.x for a in known if a.force)
    y = math.fsum(a.force.y for a in known if a.force)
    moments = [a.about(CENTRE, places) for a in body.forces]
    size = max((math.hypot(*a.force) for a in known if a.force), default=0.0)
    if math.hypot(x, y) > BALANCED * size:
        yield f"the forces on {body.name} come to ({x:.3g}, {y:.3g})"
    if abs(math.fsum(moments)) > BALANCED * max(map(abs, moments), default=0.0):
        yield f"the moments on {body.name} come to {math.fsum(moments):.3g}"


def _one_sided(diagram: Diagram) -> Iterator[str]:
    """Yield the pins at which two bodies do not give one another the same force."""
    found = {
        (b.name, a.by, a.point): a for b in diagram.bodies for a in b.forces if a.kind == "pin"
    }
    for (body, by, point), here in found.items():
        there = found.get((by, body, point))
        if there is not None and body < by and not _are_opposite(here, there):
            yield f"{body} and {by} give one another at {point} {here.force} and {there.force}"


def _are_opposite(here: Acting, there: Acting) -> bool:
    if here.force is None or there.force is None:
        return here.force is there.force
    size = max(math.hypot(*here.force), math.hypot(*there.force))
    gap = math.hypot(here.force.x + there.force.x, here.force.y + there.force.y)
    turn = abs(here.moment + there.moment)
    return gap <= BALANCED * size and turn <= BALANCED * max(abs(here.moment), abs(there.moment))


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
