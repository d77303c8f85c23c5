"""Friction at pins, guides and contacts, as coefficients and lengths in SI."""

from typing import assert_never

from ...base.frozen import frozen
from ...formula.tree import Call, Formula, number, product, total
from ...formula.walk import symbols
from ...source import Span
from .joints import MeshKind
from .targets import Sense


@frozen
class PinFriction:
    """A pin whose friction gives the couple ``radius · |R|`` against the relative rotation.

    ``radius`` is that of the friction circle: f·d/2 where f is the journal coefficient,
    (d/2)·sin(atan f) by Coulomb's law. ``carrier`` is the link that the pin is fast in:
    empty for the ground (a pivot) and for the slider of a guided point. It is ``assumed``
    where the description does not say so and the mechanism does not either.
    """

    point: str
    carrier: str
    radius: Formula
    span: Span
    assumed: bool = False


@frozen
class GuideFriction:
    """A guide, or a roller on it, that resists with ``factor · |N|`` along itself."""

    point: str
    factor: Formula
    span: Span


@frozen
class FaceFriction:
    """A slot or a contact that resists with ``factor · |N|`` along the face."""

    point: str
    factor: Formula
    span: Span


@frozen
class WheelFriction:
    """A pair of gears, a belt or a rack that loses ``factor`` of the force it passes on.

    The loss resists the rim of the first wheel, or the rack: ``point`` is its pivot, or the
    rack's, and ``joint`` the id. What arrives beyond is the force passed on.
    """

    joint: str
    kind: MeshKind
    point: str
    factor: Formula
    span: Span


@frozen
class ThreadFriction:
    """A screw on whose thread, of mean diameter ``thread``, Coulomb's friction acts.

    ``joint`` is the screw's id, ``point`` the slider that it moves.
    """

    joint: str
    point: str
    factor: Formula
    thread: Formula
    span: Span


@frozen
class CollarFriction:
    """A collar that takes the thrust of a screw: ``factor`` of it resists at a mean ``radius``.

    It turns with the screw on what stands still. ``joint`` is the screw's id, ``point`` the
    slider that it moves.
    """

    joint: str
    point: str
    factor: Formula
    radius: Formula
    span: Span


@frozen
class PivotFriction:
    """A collar, a disc brake or a clutch on a pivot: ``factor · |thrust|`` at a mean ``radius``.

    It acts between ``link``, which turns on pivot ``point``, and what stands still. The
    ``thrust`` is a force along the pivot's axis, a multiple of a load or a given one; the
    factor counts the faces.
    """

    point: str
    link: str
    factor: Formula
    radius: Formula
    thrust: Formula
    span: Span


@frozen
class RopeFriction:
    """A rope that slides around a pulley, its tensions as e^(μθ) where it is about to slip.

    ``joint`` is the rope's id, ``point`` the axle of the pulley, which is the ``place``-th of
    its route. On a drum that turns with ``link`` the rope acts at ``reach``: its radius,
    negative where the rope goes clockwise around it; None for a pulley that is held.
    """

    joint: str
    point: str
    place: int
    coefficient: Formula
    wrap: Formula
    reach: Formula | None
    link: str
    span: Span

    @property
    def factor(self) -> Formula:
        """Return the difference of both tensions over their mean, whichever way the rope slides.

        They are to each other as e^(μθ) to 1.
        """
        return tension_share(self.tensions)

    @property
    def tensions(self) -> Formula:
        """Return the larger tension over the smaller one, e^(μθ)."""
        return Call("exp", (product([(self.coefficient, 1), (self.wrap, 1)]),))


def coulomb(coefficient: Formula) -> Formula:
    """Return sin(arctan f): a pin's friction circle over its radius, by Coulomb's law."""
    return Call("sin", (Call("atan", (coefficient,)),))


def tension_share(ratio: Formula) -> Formula:
    """Return 2·(q − 1)/(q + 1): the difference over the mean of tensions whose ratio is q."""
    less, more = total([ratio, number(-1)]), total([ratio, number(1)])
    return product([(number(2), 1), (less, 1), (more, -1)])


JointFriction = (
    PinFriction
    | GuideFriction
    | FaceFriction
    | WheelFriction
    | ThreadFriction
    | CollarFriction
    | PivotFriction
    | RopeFriction
)


def _sizes(joint: JointFriction) -> tuple[Formula, ...]:
    """Return the coefficients, lengths and forces that the friction of a joint depends on."""
    match joint:
        case PinFriction(radius=radius):
            return (radius,)
        case GuideFriction(factor=factor) | FaceFriction(factor=factor):
            return (factor,)
        case WheelFriction(factor=factor):
            return (factor,)
        case ThreadFriction(factor=factor, thread=length):
            return factor, length
        case CollarFriction(factor=factor, radius=length):
            return factor, length
        case PivotFriction(factor=factor, radius=length, thrust=thrust):
            return factor, length, thrust
        case RopeFriction(factor=factor, reach=reach):
            return (factor,) if reach is None else (factor, reach)
        case _:
            assert_never(joint)


@frozen
class Friction:
    """All friction in a mechanism, and which way it moves.

    ``tightening``: the driving load moves along its arrow. ``efficiency`` overrides the rest.
    ``everywhere`` states that every pin was said to have friction.
    """

    joints: tuple[JointFriction, ...] = ()
    sense: Sense = "tightening"
    efficiency: Formula | None = None
    everywhere: bool = False

    @property
    def is_ideal(self) -> bool:
        """Return whether there is no friction at all."""
        return not self.joints and self.efficiency is None

    @property
    def parameters(self) -> frozenset[str]:
        """Return the names that friction itself depends on."""
        own = () if self.efficiency is None else (self.efficiency,)
        return symbols(*own, *(size for joint in self.joints for size in _sizes(joint)))
