"""Why a ratio of loads is zero or infinite: what stands still, or moves across its load."""

from collections.abc import Iterable, Sequence

from ..algebra.angle import QUARTER
from ..algebra.factors import Factor
from ..algebra.orders import AngleRoot, order
from ..algebra.product import Product
from ..algebra.sums import canonical
from ..formula.tree import Formula
from ..formula.walk import constants, symbols
from ..kinematics.plan import Plan
from ..model.mechanism import Force
from ..model.parts.loads import SpeedAgainst
from ..pose.pose import Pose, Vector
from ..power.balance import AlgebraicResult, Balance, Term
from .analysis import Acted, Cause, DeadCentre


def cause(
    factor: Factor, at: Sequence[AngleRoot], item: AlgebraicResult, balance: Balance, side: int
) -> Cause:
    """Return whether the point of a load stands still or moves across it, if that is known."""
    ratio = across_of(item, balance, side)
    if (
        ratio is None
        or _is_of_sizes(factor, balance)
        or not _is_theirs(factor, at, item, balance, side)
    ):
        return "other"
    if ratio and not _vanishes(ratio, factor, at):
        return "perpendicular load"
    loads = {t.load.name: t.load for t in balance.terms}
    still, moving = _still_and_moving(item, side)
    return DeadCentre(*(_acted(loads[name].against) for name in (still, moving)))


def _is_of_sizes(factor: Factor, balance: Balance) -> bool:
    """Return whether dimensions alone decide: equal ones are a choice, and no position."""
    names = _names(factor.formula())
    return bool(names) and names <= _sizes(balance.plan.graph.pose)


def _sizes(pose: Pose) -> frozenset[str]:
    """Return the names of what stays as it is: lengths within rigid bodies, radii and pitches."""
    moved = {t.name for t in pose.mechanism.telescopes}
    rigid = {name: frame for name, frame in pose.frames.items() if name not in moved}
    bodies = [pose.mechanism.fixed, *map(frozenset, rigid.values())]
    between = [v for ends, v in pose.vectors.items() if not any(map({*ends}.issubset, bodies))]
    inside = (vector for frame in rigid.values() for vector in frame.values())
    found = frozenset(d.name for d in pose.definitions).union(pose.rates)
    kept = _names(*(radius.formula() for radius in pose.radii.values())) | _in_lengths(inside)
    return kept - _in_lengths(between) - found


def _in_lengths(vectors: Iterable[Vector]) -> frozenset[str]:
    return _names(*(arm.length.formula() for vector in vectors for arm in vector))


def _names(*formulas: Formula) -> frozenset[str]:
    """Return all names in formulas, those of numbers too."""
    return symbols(*formulas).union(constant.name for constant in constants(formulas))


def _is_theirs(
    factor: Factor, at: Sequence[AngleRoot], item: AlgebraicResult, balance: Balance, side: int
) -> bool:
    """Return whether the two loads do it by themselves, not one that is tied to the other.

    With T = 0.3*F at D, a torque may stand still while D moves, and the point of F does not.
    """
    terms = {t.load.name: t for t in balance.terms}
    still, moving = (terms[name] for name in _still_and_moving(item, side))
    if not any(t.tie and t.tie[0] == moving.load.name for t in balance.terms):
        return True
    return _vanishes(canonical(still.power[0] / moving.power[0]), factor, at)


def _still_and_moving(item: AlgebraicResult, side: int) -> tuple[str, str]:
    """Return the load of which the power is zero, and the other one."""
    return (item.below, item.above) if side > 0 else (item.above, item.below)


def across_of(item: AlgebraicResult, balance: Balance, side: int) -> Product | None:
    """Return the velocity of a load's point across it, per power of the other load.

    0 for a torque, whose power is zero where its link stands still; None where there is no one
    motion that both have a part in.
    """
    still, moving = _still_and_moving(item, side)
    tied = {name for t in balance.terms if t.tie for name in (t.load.name, t.tie[0])}
    if not still or still in tied or balance.plan.mobility != 1:
        return None
    terms = {t.load.name: t for t in balance.terms}
    if not terms[moving].power[0]:
        return None
    across = _across(balance.plan, terms[still])
    return canonical(across / terms[moving].power[0]) if across else across


def _acted(speed: SpeedAgainst) -> Acted:
    """Return the point, link or pair that a load acts on, by the speed against which it works."""
    return Acted(speed.of, is_distance=speed.kind == "distance")


def _vanishes(ratio: Product, factor: Factor, at: Sequence[AngleRoot]) -> bool:
    """Return whether a ratio is zero with a factor: by its order where that has roots."""
    if at:
        return all((order(ratio, root.name, root.value) or 0) > 0 for root in at)
    return ratio.factors.get(factor, 0) > 0


def _across(plan: Plan, term: Term) -> Product:
    """Return the component of a load's point velocity across the load; 0 for a torque."""
    if not isinstance(term.load, Force) or term.line is None:
        return Product(0)
    return plan.component(term.load.point, term.line + QUARTER)[0]
