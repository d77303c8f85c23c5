"""The equilibrium of every free body, written from what each joint transmits.

Every link and every pin is cut free. A pin transmits a force in any direction, a guide one
across its direction, a pivot any force of the ground; a rod without a couple of its own
transmits a tension along itself and nothing else. So each pin gives two equations, forces
in x and y, and each body of three or more pins (or with a couple) three: forces in x and
y, and moments about its first point. A rod's three hold by themselves.

Forces are in newtons, and positive as they act on the pin; a tension is positive.
"""

import math
from collections.abc import Iterator, Mapping

from ..base.frozen import frozen
from ..base.named import NamedTuple
from .assembly import (
    GROUND,
    Action,
    AssembledBodies,
    Couple,
    Cylinder,
    PinOnBody,
    Plane,
    PointForce,
    RigidBody,
    Transfer,
    Translation,
    Wrench,
)
from .tolerances import VANISHED

X, Y = Plane(1.0, 0.0), Plane(0.0, 1.0)


class UnknownForce(NamedTuple):
    """A force to be found: what exerts it, on which pin (``""`` for a tension), which component."""

    by: str
    on: str
    component: str


@frozen
class EquilibriumSystem:
    """Sums of forces and moments: ``rows · unknowns + Σ load · loads[load] = 0``.

    Rows and columns are numbered; ``loads`` gives what one unit of each load adds to each
    row's sum.
    """

    rows: tuple[Mapping[int, float], ...]
    unknowns: tuple[UnknownForce, ...]
    loads: Mapping[str, Mapping[int, float]]


class _RowBuilder:
    """Rows in the making: a pair of rows for each pin, three for each body that needs them."""

    def __init__(self) -> None:
        self.rows: list[dict[int, float]] = []
        self.unknowns: list[UnknownForce] = []
        self.pins: dict[str, int] = {}
        self.bodies: dict[str, int] = {}

    def pin(self, point: str) -> int:
        """Return the number of the pin's first row; its rows are added when first asked for."""
        if point not in self.pins:
            self.pins[point] = self._more(2)
        return self.pins[point]

    def body(self, name: str) -> int:
        """Return the number of the body's first row: ΣX, then ΣY, and ΣM about its first point.

        The rows are added when first asked for.
        """
        if name not in self.bodies:
            self.bodies[name] = self._more(3)
        return self.bodies[name]

    def force(self, unknown: UnknownForce, point: str, along: Plane) -> int:
        """Let an unknown force act on a pin and return its column."""
        column = len(self.unknowns)
        self.unknowns.append(unknown)
        self.act(column, self.pin(point), along)
        return column

    def act(self, column: int, row: int, along: Plane) -> None:
        """Let an unknown force act on the pin or body whose rows begin here."""
        for i, part in enumerate(_components(along)):
            self.rows[row + i][column] = part

    def _more(self, number: int) -> int:
        self.rows.extend({} for _ in range(number))
        return len(self.rows) - number


def _components(vector: Plane) -> tuple[float, float]:
    """Return x and y, a rounded zero as 0."""
    least = VANISHED * math.hypot(vector.x, vector.y)
    return (
        vector.x if abs(vector.x) > least else 0.0,
        vector.y if abs(vector.y) > least else 0.0,
    )


def equilibrium(assembly: AssembledBodies) -> EquilibriumSystem:
    """Return the equations of every free body of an assembly."""
    sums = _RowBuilder()
    actions = [a for several in assembly.loads.values() for a in several]
    actions += [
        a for transfer in assembly.transfers for a in (*transfer.actions, *transfer.bearings)
    ]
    twisted = {a.body for a in actions if isinstance(a, Couple | Wrench)}
    twisted |= {contact.body for contact in assembly.contacts}
    for body in assembly.bodies:
        if len(body.points) == 2 and body.name not in twisted:
            _tension(sums, body)
        else:
            _pin_forces(sums, body)
    for point in assembly.pivots:
        sums.force(UnknownForce("ground", point, "x"), point, X)
        sums.force(UnknownForce("ground", point, "y"), point, Y)
    for guide in assembly.guides:
        sums.force(UnknownForce("guide", guide.point, "normal"), guide.point, guide.along.turned())
    for slide in assembly.slides:
        _translation(sums, slide)
    for contact in assembly.contacts:
        _contact(sums, contact)
    for transfer in assembly.transfers:
        _transfer(sums, transfer)
    for cylinder in assembly.cylinders:
        _cylinder(sums, cylinder)
    loads = {name: _load(sums, actions) for name, actions in assembly.loads.items()}
    return EquilibriumSystem(tuple(sums.rows), tuple(sums.unknowns), loads)


def _tension(sums: _RowBuilder, rod: RigidBody) -> None:
    (tail, a), (head, b) = rod.points.items()
    length = math.hypot(b.x - a.x, b.y - a.y)
    along = Plane(b.x - a.x, b.y - a.y).times(1 / length) if length else Plane(0.0, 0.0)
    column = sums.force(UnknownForce(rod.name, "", "tension"), tail, along)
    sums.act(column, sums.pin(head), along.times(-1))


def _pin_forces(sums: _RowBuilder, body: RigidBody) -> None:
    first = sums.body(body.name)
    for point, arm in body.points.items():
        x, y = _components(arm)
        for component, along, lever in (("x", X, y), ("y", Y, -x)):
            column = sums.force(UnknownForce(body.name, point, component), point, along)
            sums.act(column, first, along.times(-1))
            sums.rows[first + 2][column] = lever


def _translation(sums: _RowBuilder, slide: Translation) -> None:
    """Let pins act on a body that its guide holds across its direction and against turning."""
    _pin_forces(sums, slide.body)
    first = sums.body(slide.body.name)
    across, couple = len(sums.unknowns), len(sums.unknowns) + 1
    sums.unknowns.append(UnknownForce("guide", slide.body.name, "normal"))
    sums.unknowns.append(UnknownForce("guide", slide.body.name, "couple"))
    sums.act(across, first, slide.along.turned())
    sums.rows[first + 2][couple] = 1.0


def _contact(sums: _RowBuilder, contact: PinOnBody) -> None:
    """Let a body push a pin along the normal, and the pin push back where it is."""
    n = Plane(*_components(contact.normal))
    column = sums.force(UnknownForce(contact.body, contact.point, contact.kind), contact.point, n)
    first = sums.body(contact.body)
    sums.act(column, first, n.times(-1))
    sums.rows[first + 2][column] = contact.arm.y * n.x - contact.arm.x * n.y


def _cylinder(sums: _RowBuilder, cylinder: Cylinder) -> None:
    """Let a pin act on each part of a telescope, and the parts on one another where they end.

    The first part ends at the pin of the second, and pushes across with a force and a couple;
    the moments of each are about its own pin.
    """
    for point in cylinder.ends:
        part = sums.body(cylinder.part(point))
        for component, along in (("x", X), ("y", Y)):
            column = sums.force(UnknownForce(cylinder.name, point, component), point, along)
            sums.act(column, part, along.times(-1))
    first, second = (sums.body(cylinder.part(point)) for point in cylinder.ends)
    across, couple = len(sums.unknowns), len(sums.unknowns) + 1
    sums.unknowns.append(UnknownForce(cylinder.name, "", "side"))
    sums.unknowns.append(UnknownForce(cylinder.name, "", "couple"))
    sums.act(across, second, cylinder.along.turned())
    sums.act(across, first, cylinder.along.turned().times(-1))
    sums.rows[first + 2][across] = -cylinder.reach
    sums.rows[second + 2][couple] = 1.0
    sums.rows[first + 2][couple] = -1.0


def _transfer(sums: _RowBuilder, transfer: Transfer) -> None:
    column = len(sums.unknowns)
    sums.unknowns.append(UnknownForce(transfer.name, "", "transfer"))
    for row, amount in _places(sums, (*transfer.actions, *transfer.bearings)):
        sums.rows[row][column] = sums.rows[row].get(column, 0.0) + amount


def _load(sums: _RowBuilder, actions: tuple[Action, ...]) -> dict[int, float]:
    row: dict[int, float] = {}
    for place, amount in _places(sums, actions):
        row[place] = row.get(place, 0.0) + amount
    return row


def _places(sums: _RowBuilder, actions: tuple[Action, ...]) -> Iterator[tuple[int, float]]:
    """Yield the rows of the equations in which actions stand, and how large they are there."""
    for action in actions:
        match action:
            case PointForce(point, force):
                yield from enumerate(_components(force), sums.pin(point))
            case Couple(name) if name == GROUND:
                pass
            case Couple(name, moment):
                yield sums.body(name) + 2, moment
            case Wrench(name, force, moment):
                yield from enumerate((*_components(force), moment), sums.body(name))
