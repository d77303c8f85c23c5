"""Symbols for speeds: ``V_A`` of a point, ``omega_OBA`` of a link, positive as things move.

Speeds are magnitudes in the closing motion, as textbooks print them: each symbol is
positive at the default pose when the first load does positive work. With several
independent motions, or without default values, they are signed as the unknowns are.
"""

from collections.abc import Mapping

from ...algebra.angle import Angle
from ...algebra.product import ONE, Product
from ...algebra.sums import add, canonical, readable
from ...base.named import NamedTuple
from ...formula.tree import Formula, Sum, Symbol, product, total
from ...kinematics.graph import LinearForm, Rule, SpeedKind, UnknownSpeed
from ...kinematics.plan import Plan
from ...power.balance import Balance
from ...power.numbers import default_values
from ..sentences.order import positive_first


class WrittenUnknown(NamedTuple):
    """An unknown as ``factor · symbol``; ``point`` is the one whose speed the symbol is."""

    symbol: Symbol
    factor: Product
    point: str = ""


WrittenUnknowns = Mapping[int, WrittenUnknown]


class SpeedNotation:
    """Knows how each unknown is written, and which way it is positive."""

    def __init__(self, balance: Balance) -> None:
        self._plan: Plan = balance.plan
        self._values = default_values(balance.plan)
        self._closing = self._sign_of_closing(balance)

    def sign(self, value: Product) -> int:
        """Return the sign of a product at the default pose; +1 where it has none."""
        try:
            return -1 if value.evaluate(self._values) < 0 else 1
        except (KeyError, ZeroDivisionError):
            return 1

    def _sign_of_closing(self, balance: Balance) -> int:
        first = next((t for t in balance.terms if any(t.power)), None)
        if first is None or self._plan.mobility != 1:
            return 1
        return self.sign(first.power[0])

    def _sense(self, unknown: int, size: Product = ONE) -> int:
        """Return the sign of ``size · unknown`` in the closing motion."""
        if self._plan.mobility != 1:
            return 1
        speed = size * self._plan.speeds[unknown][0]
        return self.sign(self._bound(speed)) * self._closing

    def _bound(self, value: Product) -> Product:
        for name, definition in ((b.name, b.value) for b in self._plan.bindings):
            if name not in self._values:
                self._values[name] = _evaluated(definition, self._values)
        return value

    def of_point(self, unknown: int, point: str) -> WrittenUnknown | None:
        """Return an unknown written by the speed of a point that moves with it alone."""
        velocity = self._plan.graph.velocities.get(point, ())
        kind = self._plan.graph.unknowns[unknown].kind
        if len(velocity) != 1 or velocity[0].unknown != unknown or kind is SpeedKind.COMPONENT:
            return None
        size = velocity[0].size
        sense = Product(self._sense(unknown, size))
        return WrittenUnknown(Symbol(f"V_{point}"), sense / size, point)

    def of_itself(self, unknown: int) -> WrittenUnknown:
        """Return an unknown written by itself: a spin, a slide, a projection."""
        what = self._plan.graph.unknowns[unknown]
        point = what.of if what.kind is SpeedKind.SLIDE else ""
        return WrittenUnknown(Symbol(_name(what, self._plan)), Product(self._sense(unknown)), point)


def _evaluated(value: Product, values: Mapping[str, float]) -> float:
    try:
        return value.evaluate(values)
    except (KeyError, ZeroDivisionError):
        return 1.0


def _name(unknown: UnknownSpeed, plan: Plan) -> str:
    match unknown.kind:
        case SpeedKind.SPIN:
            return f"omega_{unknown.of}"
        case SpeedKind.SLIDE:
            return f"V_{unknown.of}"
        case SpeedKind.COMPONENT:
            return f"V_{unknown.of}_{_axis(unknown) or _rod(unknown, plan)}"


def _axis(unknown: UnknownSpeed) -> str:
    """Return the axis along which a velocity is projected, "" for another direction."""
    direction = unknown.direction
    if direction is None or direction.terms or direction.degrees % 90:
        return ""
    return "y" if direction.degrees % 180 else "x"


def _rod(unknown: UnknownSpeed, plan: Plan) -> str:
    """Return the rod on which a velocity is projected, or n for its normal."""
    for relation in plan.graph.relations:
        on_rod = relation.rule is Rule.PROJECTION and relation.along == unknown.direction
        if on_rod and unknown.of in relation.points:
            return relation.link
    return "n"


def times(factor: Product, named: WrittenUnknown) -> Formula:
    """Return ``factor · symbol``, a long factor as it is read."""
    read = readable(canonical(factor), [factor])
    return product([(read.formula(), 1), (named.symbol, 1)])


def in_written_unknowns(form: LinearForm, names: WrittenUnknowns) -> Formula:
    """Return a linear form written with the names of its unknowns."""
    parts: dict[WrittenUnknown, list[Product]] = {}
    for u, p in form.items():
        parts.setdefault(names[u], []).append(p * names[u].factor)
    sums = [(add(ps), named) for named, ps in parts.items()]
    return total(positive_first(times(p, named) for p, named in sums if p))


def direction_formula(angle: Angle) -> Formula:
    """Return a direction, an axis by its letter."""
    if not angle.terms and angle.degrees % 360 in (0, 90):
        return Symbol("y" if angle.degrees % 360 else "x")
    formula = Angle(angle.terms, angle.degrees % 360).formula()
    return total(positive_first(formula.terms)) if isinstance(formula, Sum) else formula
