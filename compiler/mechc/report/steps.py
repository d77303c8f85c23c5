"""The derivation: what a person would write on paper, as data.

Speeds are named ``V_A`` (of point A), angular velocities ``omega_OBA`` (of a link).
Every relation is a pair of formulas; the words for each rule, in each language,
belong to whoever prints.
"""

from collections.abc import Mapping
from enum import StrEnum
from types import MappingProxyType
from typing import Literal

from ..formula.tree import Formula
from ..frozen import frozen, replace
from ..model.mechanism import Require
from ..model.result import Definition
from ..named import NamedTuple
from ..pose.pose import LoopKind
from ..study.analysis import Analysis
from ..units import Dimension


class Rule(StrEnum):
    """The rule of mechanics that gives a relation."""

    HELD = "held"
    """Drives that stay at their values while another one moves."""
    LEVER = "lever"
    """Points of a link that turns about a pivot: V = ω·r, so speeds are as the arms."""
    ARM = "arm"
    """One point of a link that turns about a pivot: V = ω·r."""
    PROJECTION = "projection"
    """Equal projections of the end velocities on the line of a rod."""
    ROTATION = "rotation"
    """The angular velocity of a link from the velocities of two of its points."""
    BODY = "body"
    """The velocity of a point of a link from another point's and the rotation."""
    PLANE = "plane"
    """What the velocity of a point is made of: another point's and the rotation of their link."""
    DYAD = "dyad"
    """The velocity of a point from its projections on two rods."""
    TOGETHER = "together"
    """Relations that must be solved together."""
    GUIDE = "guide"
    """A point that moves along its guide."""
    TURNING = "turning"
    """A link in a slot that turns with the link that has it."""
    SLOT = "slot"
    """Equal velocities of a pin and the body under it across a slot."""
    CONTACT = "contact"
    """Equal velocities of two bodies along their common normal."""
    GEAR = "gear"
    """Pitch circles that roll on one another."""
    BELT = "belt"
    """A belt or chain that runs with two rims."""
    ON_ARM = "on_arm"
    """Wheels that run with one another as seen from the arm that carries their centres."""
    RACK = "rack"
    """A rack that moves with the rim of its gear."""
    SCREW = "screw"
    """A nut that moves by the pitch for each turn."""
    ROPE = "rope"
    """A rope that keeps its length."""
    PARTING = "parting"
    """The rate at which the distance of two points grows."""
    COMPONENT = "component"
    """The component of a point's velocity along the load that acts on it."""
    COMPONENT_OF_ROTATION = "component_of_rotation"
    """The same where the point turns about a pivot: as the arm of the load."""
    COMPONENT_OF_BODY = "component_of_body"
    """The same from another point's velocity and the rotation of their link."""
    COMPONENT_OF_TWO = "component_of_two"
    """The same from the projections of the velocity on two lines."""


PositionKind = Literal[LoopKind, "length", "equal", "sum"]
"""How a loop is solved, or gives one ``length``, that ``equal`` lengths solve it, or that a vector
is the ``sum`` of others."""


@frozen
class PositionStep:
    """The position by one loop, or of one vector: directions and lengths, in order.

    ``points`` is what the loop goes through (see ``SolvedLoop``), or the ends of the vector;
    ``definitions`` are those of its names that the derivation needs.
    """

    kind: PositionKind
    points: tuple[str, ...]
    is_clockwise: bool | None
    definitions: tuple[Definition, ...]


class Equation(NamedTuple):
    """``left = right``."""

    left: Formula
    right: Formula


@frozen
class Step:
    """One numbered step: the rule, the points and link it is applied to, what it gives.

    ``subject`` are names of the drawing: for LEVER and ARM the pivot first, then the points;
    for PROJECTION the two ends of the rod; for TURNING both links; for SLOT and CONTACT the pin
    and the body, for GEAR
    and BELT the two pivots, for ON_ARM the arm and the two centres, for RACK the pivot and the
    rack, for PARTING the two points; for TOGETHER the links involved; for COMPONENT and its
    kinds the point and the load last, ``V_A_P`` being the speed of A along P, the pivot, or the
    link and its other point, first; for HELD the coordinates.
    ``relations`` is what the rule says; ``results`` the same solved for the new speeds. Of
    TOGETHER ``reasons`` are the rules behind the relations, each with what it is applied to.
    """

    rule: Rule
    subject: tuple[str, ...]
    relations: tuple[Equation, ...]
    results: tuple[Equation, ...]
    reasons: tuple[tuple[Rule, tuple[str, ...]], ...] = ()


@frozen
class PowerTerm:
    """The power of one load: ``times · load · speed``; ``speed`` is signed along the load."""

    load: str
    point: str
    times: Formula
    speed: Formula


class SentenceKind(StrEnum):
    """The kind of a sentence; the words belong to each language."""

    RELEASED = "released"
    """The release of constraints."""
    PIVOT = "pivot"
    """A pivot is released."""
    GUIDE = "guide"
    """A point, or a body that translates, is released from its guide."""
    PIN = "pin"
    """A link is released from a pin."""
    TOUCH = "touch"
    """A slot or contact is released."""
    ROPE_RELEASED = "rope released"
    """A rope is released: its falls grow shorter."""
    IDLE = "idle"
    """A joint is released where no load does work."""
    ROD = "rod"
    """The force of a rod without loads acts along it."""
    SMOOTH = "smooth"
    """A guide presses across itself only."""
    SHARED = "shared"
    """Forces across the line of symmetry cancel."""
    TIGHTENING = "tightening"
    """Friction while the drive moves along its force."""
    TIGHTENING_HELD_BACK = "tightening, held back"
    """The same, where the loads drive and the drive holds them back."""
    RELEASING = "releasing"
    """Friction while the drive moves against its force."""
    RELEASING_HELD_BACK = "releasing, held back"
    """The same, where the loads drive and the drive holds them back."""
    RELEASING_BY_LOAD = "releasing, by the load"
    """The same, where the load below the line is named as what drives."""
    PIN_FRICTION = "pin friction"
    """Friction in a pin is a couple."""
    GUIDE_FRICTION = "guide friction"
    """Friction in a guide goes with the force across it."""
    ROD_FORCES = "rod forces"
    """The names of forces in rods."""
    PART = "part"
    """One of the equal parts of a mechanism is looked at."""
    UNIT = "unit"
    """The unit of forces."""
    UNIT_AND_DRIVE = "unit and drive"
    """The same where the load of the drive is met: it is the ratio that is asked for."""
    IN_COMPRESSION = "pressed"
    """A rod is in compression."""
    IN_TENSION = "pulled"
    """A rod is in tension."""
    INTERNAL_TANGENT = "crossed"
    """A rod's force along the internal common tangent of the friction circles."""
    EXTERNAL_TANGENT = "outer"
    """A rod's force along an external common tangent of the friction circles."""
    PARALLEL = "parallel"
    """A rod's force along the external common tangent of equal friction circles."""
    SINGLE = "single"
    """A rod's force with friction at one end."""
    FACE = "face"
    """A force on a face, turned by the angle of friction."""
    MOMENTS = "moments"
    """Moments about a pivot without friction."""
    TURNS_LEFT = "turns left"
    """Moments about a pivot with friction, the link turning counter-clockwise."""
    TURNS_RIGHT = "turns right"
    """The same for a link that turns clockwise."""
    SQUARED = "squared"
    """Moments with friction in the pivot, solved for a force."""
    ALONG = "along"
    """Forces along a guide without friction."""
    ALONG_WITH_FRICTION = "along with friction"
    """Forces along a guide with friction."""
    PIN_OF_RODS = "pin of rods"
    """Forces on a pin between rods."""
    FIRST_ORDER = "first order"
    """Frictions under the forces that there are without them."""
    FIRST_ORDER_LESS = "first order, less"
    """The same where the drive is driven back."""
    FIRST_ORDER_SAME = "first order, same"
    """Where they give what the exact forces give."""
    SLIP_OF_PIN = "slip of pin"
    """The slip and the coefficient of a pin."""
    SLIP_OF_FACE = "slip of face"
    """The slip of a guide, face or pair."""
    ROPE_FRICTION = "rope friction"
    """The tensions of a rope that slides around a pulley."""
    ROPE_SMALLER = "rope, smaller tension"
    """The name of the smaller of both tensions, and what the friction is."""
    ROPE_MEAN = "rope, mean"
    """What counts as the normal force of a rope, and its coefficient."""
    ROPES = "ropes"
    """Frictions of ropes that slide around pulleys."""
    STRAIGHT = "straight"
    """Frictions of what is pressed along one line each."""
    EFFICIENT = "efficient"
    """An efficiency that was given."""
    ITERATED = "iterated"
    """Frictions that depend on each other."""
    POWERS = "powers of friction"
    """What each friction that is iterated adds to the drive."""
    ITERATED_AGAIN = "iterated again"
    """The same for another result."""
    EQUILIBRIUM = "equilibrium"
    """Free bodies are in equilibrium."""
    EQUAL_PARTS = "equal parts"
    """One of equal parts is looked at, and all that act on what they share."""
    FORCE_IN_ROD = "force in rod"
    """The name of the force in a rod."""
    FORCE_OF_GROUND = "force of ground"
    """The names of the components of the force at a pivot."""
    FORCE_AT_PIN = "force at pin"
    """The names of the components of the force at a pin."""
    FORCE_ALONG_ARM = "force along arm"
    """The same along an arm and across it."""
    FORCE_OF_GUIDE = "force of guide"
    """The name of the force of a guide."""
    FORCE_OF_TOUCH = "force of touch"
    """The name of the force of a body on a pin that slides on it."""
    FORCE_OF_RIM = "force of rim"
    """The name of the force between the rims of two wheels."""
    FORCE_OF_RACK = "force of rack"
    """The name of the force between a wheel and a rack."""
    FORCE_OF_THREAD = "force of thread"
    """The name of the force of a screw on its nut."""
    FORCE_OF_ROPE = "force of rope"
    """The name of the tension of a rope."""
    COUPLE_IN_SLOT = "couple in slot"
    """The name of the couple between a link in a slot and the one that has it."""
    FORCES_ALONG = "forces along"
    """Forces on a link in a direction."""
    FORCES_ACROSS = "forces across"
    """Forces on a link across a rod."""
    PIN_ALONG = "pin along"
    """Forces on a pin in a direction."""
    PIN_ACROSS = "pin across"
    """Forces on a pin across a rod."""
    MADE_UP = "made up"
    """The force on a link at a pin, of those that act there."""
    MADE_UP_BY_GROUND = "made up by ground"
    """The same of the ground, at a pivot."""
    SOLVED_TOGETHER = "solved together"
    """The forces that several sums give together."""


@frozen
class Paragraph:
    """A sentence with the equations that it leads to.

    ``names`` are the points, links and loads that the sentence mentions, by the places that
    its words have for them; ``formulas`` what it has of mathematics.
    """

    sentence: SentenceKind
    equations: tuple[Equation, ...] = ()
    names: Mapping[str, tuple[str, ...]] = MappingProxyType({})
    formulas: Mapping[str, Formula] = MappingProxyType({})


@frozen
class Explanation:
    """How results were found that are explained together, such as the components of one force.

    ``where`` is what the equations rest on.
    """

    results: tuple[str, ...]
    paragraphs: tuple[Paragraph, ...]
    where: tuple[Definition, ...] = ()


class SpeedChain(NamedTuple):
    """The ratio of two speeds as a product of ratios found one after another: ``V_K/V_A``."""

    ratio: Formula
    links: tuple[Formula, ...]
    product: Formula


class NamedRatio(NamedTuple):
    """The ratio of a speed to the drive's, under the name that results have it by."""

    name: str
    formula: Formula
    dimension: Dimension


@frozen
class LastStep:
    """The solution of the power equation: a ratio of loads in the speeds that were named.

    ``chain`` is the ratio of these speeds, None where one relation gave it.
    """

    chain: SpeedChain | None
    ratio: Equation


@frozen
class Derivation:
    """The velocity steps, the power equation (or several, at mobility m), the results.

    ``explanations`` are those of results that need more than the power equation, ``position`` how
    what all of these mention follows from the loops, ``last_steps`` what the power equation
    gives. ``ratios`` are those of speeds that the steps have given a name. ``requires`` are the
    conditions of use, in names of the position where they ask something of the pose.
    """

    steps: tuple[Step, ...]
    terms: tuple[PowerTerm, ...]
    balances: tuple[Equation, ...]
    results: tuple[Analysis, ...]
    explanations: tuple[Explanation, ...] = ()
    position: tuple[PositionStep, ...] = ()
    last_steps: tuple[LastStep, ...] = ()
    ratios: tuple[NamedRatio, ...] = ()
    requires: tuple[Require, ...] = ()


def unexplained(derivation: Derivation) -> Derivation:
    """Leave out how the results came about, so that they define what they rest on themselves.

    What is shown together still is.
    """
    together = tuple(Explanation(e.results, ()) for e in derivation.explanations)
    return replace(derivation, explanations=together, position=(), ratios=())


def calculated(results: tuple[Analysis, ...]) -> Derivation:
    """Return the derivation of a calculation sheet: its results, whose formulas are given."""
    return Derivation((), (), (), results)
