"""The forces at joints that are asked for: components, sizes, directions."""

from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import partial

from ..algebra.angle import HALF_TURN, QUARTER, Angle
from ..algebra.factors import Opaque
from ..algebra.product import ONE, Product
from ..algebra.product import ZERO as NONE
from ..algebra.sums import add
from ..algebra.trigonometry import cosine
from ..base.named import NamedTuple
from ..formula.choices import SENSELESS
from ..formula.operations import count_operations
from ..formula.tree import ZERO, Call, Formula, Symbol, is_call, number, product, total
from ..formula.walk import walk
from ..kinematics.joint_refs import JointRef, held_end
from ..kinematics.plan import Plan
from ..model.mechanism import (
    Axial,
    ComponentPart,
    ForceAtJoint,
    Mechanism,
    Normal,
    Reaction,
    Require,
    Subject,
)
from ..pose.pose import Arm, Pose, Vector
from ..source import Span
from .balance import Release
from .linear_forms import Amounts, common, linear_form
from .magnitudes import largest_size, length, magnitude, root
from .numbers import pose_values
from .reactions import Reactions, Transmitted

SQUARES = 1
"""By how much a root of two squares is longer to read than the one operation that it counts for."""


class ForceFormula(NamedTuple):
    """A force at a joint: its formula, and, where it is a linear form, its coefficients.

    ``values`` is the algebra behind it, ``releases`` are how it was found.
    """

    formula: Formula
    coefficients: Amounts | None
    values: tuple[Product, ...]
    releases: tuple[Release, ...]

    @property
    def plans(self) -> tuple[Plan, ...]:
        """Return the plans that the formula's named sums come from."""
        return tuple(release.plan for release in self.releases)


def find_force(target: ForceAtJoint, pose: Pose, reactions: Reactions) -> ForceFormula | None:
    """Return a force at a joint; None where equilibrium leaves it open."""
    transmitted = reactions.of(joint_of(target, pose))
    if transmitted is None:
        return None
    match target:
        case Reaction(part="size" | "direction" as part):
            return _whole(part, transmitted, pose.mechanism)
        case _:
            return _linear(transmitted, component(transmitted, line_of(target, pose)))


def called(target: ForceAtJoint) -> str:
    """Return the name of a force in the language, whatever component is asked for."""
    match target:
        case Reaction(point, link):
            return f"R_{point} on {link}" if link else f"R_{point}"
        case Axial(_, tail, head):
            return f"N_{tail}{head}"
        case Normal(point):
            return f"N_{point}"


def joint_of(target: ForceAtJoint, pose: Pose) -> JointRef:
    """Return the joint whose force is asked for."""
    match target:
        case Reaction(point, link):
            return JointRef("pin", point, link) if link else JointRef("ground", point)
        case Axial(link) if link in _ropes(pose.mechanism):
            return JointRef("mesh", pose.mechanism.joint(link).points[0], link)
        case Axial(link):
            rod = pose.mechanism.link(link)
            return JointRef("pin", held_end(pose.mechanism, rod), link)
        case Normal(point):
            return holding(point, pose)


def _ropes(mechanism: Mechanism) -> frozenset[str]:
    return frozenset(rope.id for rope in mechanism.ropes)


def holding(point: str, pose: Pose) -> JointRef:
    """Return the joint that presses on a point across a line: a slot, a contact, a guide."""
    if any(contact.point == point for contact in pose.contacts):
        return JointRef("contact", point)
    return guiding(point, pose)


def guiding(point: str, pose: Pose) -> JointRef:
    """Return the joint at the guide of a point: of the point, or of the body that it belongs to."""
    name = next((slide.name for slide in pose.mechanism.slides_at(point)), "")
    return JointRef("slide", point, name) if name else JointRef("ground", point)


def component(transmitted: Transmitted, line: Vector) -> dict[str, Product]:
    """Return the component of a force along a unit vector, as a linear form in the loads."""
    if len(line) == 1:
        return transmitted.along(line[0].angle)
    ahead = [transmitted.along(arm.angle) for arm in line]
    aside = [transmitted.along(arm.angle + QUARTER) for arm in line]
    loads = dict.fromkeys(load for amounts in ahead for load in amounts)
    return {n: _along([a[n] for a in ahead], [a[n] for a in aside], line) for n in loads}


def _along(ahead: Sequence[Product], aside: Sequence[Product], line: Vector) -> Product:
    """Return Σ R·eᵢ·lᵢ for a unit vector Σ lᵢ·eᵢ; where R is along it that is R·e₁ over its own.

    ``aside`` are the R·nᵢ, nᵢ being eᵢ turned by +90°: Σ R·nᵢ·lᵢ vanishes along the vector.
    """
    whole = add(part * arm.length for part, arm in zip(ahead, line, strict=True))
    if add(part * arm.length for part, arm in zip(aside, line, strict=True)):
        return whole
    first = line[0].angle
    return ahead[0] / add(arm.length * cosine(arm.angle - first) for arm in line)


def line_of(target: ForceAtJoint, pose: Pose) -> Vector:
    """Return the unit vector along which a force, or a component of it, counts as positive."""
    match target:
        case Reaction(part=part):
            return (Arm(ONE, QUARTER if part == "y" else Angle()),)
        case Axial(link) if link in _ropes(pose.mechanism):
            return (Arm(ONE, HALF_TURN),)  # it is released as its falls grow, and pulls back
        case Axial(link, tail, head):
            end = joint_of(target, pose).point
            return _outwards(link, *((tail, head) if end == head else (head, tail)), pose)
        case Normal(point):
            contact = next((t for t in pose.contacts if t.point == point), None)
            guide = pose.guide_of(point) or Angle()
            return (Arm(ONE, contact.normal if contact else guide + QUARTER),)


def _outwards(link: str, tail: str, head: str, pose: Pose) -> Vector:
    """Return the unit vector of a rod; its length may be a difference such as (m − 1)·a."""
    arms = pose.vector(link, tail, head)
    if len(arms) > 1:
        whole = length(arms)
        return tuple(Arm(arm.length / whole, arm.angle) for arm in arms)
    (arm,) = arms
    try:
        turned = arm.length.evaluate(pose_values(pose)) < 0
    except KeyError:
        turned = False
    return (Arm(ONE, arm.angle + HALF_TURN if turned else arm.angle),)


def _linear(transmitted: Transmitted, amounts: Amounts) -> ForceFormula:
    return ForceFormula(
        linear_form(_kept(amounts)), amounts, tuple(amounts.values()), transmitted.releases
    )


def _whole(part: ComponentPart, transmitted: Transmitted, mechanism: Mechanism) -> ForceFormula:
    """Return the size of a force, or its direction."""
    x, y = (_kept(transmitted.along(axis)) for axis in (Angle(), QUARTER))
    loads = dict.fromkeys((*x, *y))
    if part == "direction":
        formula: Formula = Call("atan2", (linear_form(y), linear_form(x)))
    elif len(loads) > 1:
        formula = size_of_two(linear_form(x), linear_form(y))
    else:
        positive = partial(magnitude, mechanism=mechanism)
        sizes = {n: size_of(x.get(n, NONE), y.get(n, NONE), positive) for n in loads}
        formula = total(
            product([(s.formula(), 1), (Call("abs", (Symbol(n),)), 1)]) for n, s in sizes.items()
        )
    return ForceFormula(formula, None, (*x.values(), *y.values()), transmitted.releases)


def _kept(amounts: Amounts) -> Amounts:
    return {load: amount for load, amount in amounts.items() if amount}


def size_of_two(x: Formula, y: Formula) -> Formula:
    """Return the size of a vector from its components: that of one where the other is zero.

    >>> from ..formula.to_text import text
    >>> text(size_of_two(Symbol("x"), Symbol("y"))), text(size_of_two(ZERO, Symbol("y")))
    ('hypot(x, y)', 'abs(y)')
    """
    sides = [side for side in (x, y) if side != ZERO]
    return Call("hypot" if len(sides) == 2 else "abs", (*sides,)) if sides else ZERO


def has_direction(force: Formula, place: Span) -> tuple[Require, ...]:
    """Return the condition under which a force has the direction ``atan2(y, x)``.

    It is longer than rounding makes a force that is zero. What is no direction has none.
    """
    match force:
        case Call("atan2", (y, x)):
            largest = total([largest_size(x), largest_size(y)])
            least = product([(number(Fraction(SENSELESS)), 1), (largest, 1)])
            longer = size_of_two(x, y)
            return (Require(longer, ">", least, place, Subject("force", "", "")),)
        case _:
            return ()


def size_of(x: Product, y: Product, positive: Callable[[Product], Product]) -> Product:
    """Return the size of a vector in the shorter form: squares merged, or what is common outside.

    Squares merge where the force has one line: (N cos)² + (N sin)² = N². ``positive`` gives
    absolute values.
    """
    merged = positive(root(add((x * x, y * y))))
    if not x or not y:
        return merged
    shared = common(x, y)
    sides = tuple(_bare(part / shared) for part in (x, y))
    apart = positive(shared) * Product.of(Opaque(Call("hypot", sides)))
    return min(merged, apart, key=lambda size: _length(size.formula()))


def _length(formula: Formula) -> int:
    """Return how long a formula is to read, where hypot(a, b) is the root of a² + b²."""
    roots = sum(is_call(part, "hypot") for part in walk(formula))
    return count_operations(formula) + SQUARES * roots


def _bare(side: Product) -> Formula:
    """Return a side of a triangle without a minus, which its square does not show."""
    return (-side if side.coefficient < 0 else side).formula()
