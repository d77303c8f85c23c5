"""The derivation: what a person would write on paper, as data.

Speeds are named ``V_A`` (of point A), angular velocities ``omega_OBA`` (of a link).
Every relation is a pair of formulas; the words for each rule, in each language,
belong to whoever prints.
"""

from enum import StrEnum
from typing import NamedTuple

from ..formula.tree import Formula
from ..frozen import frozen
from ..model.result import Result


class Rule(StrEnum):
    """The rule of mechanics that gives a relation."""

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
    DYAD = "dyad"
    """The velocity of a point from its projections on two rods."""
    TOGETHER = "together"
    """Relations that must be solved together."""
    GUIDE = "guide"
    """A point that moves along its guide."""
    SLOT = "slot"
    """Equal velocities of a pin and the body under it across a slot."""
    CONTACT = "contact"
    """Equal velocities of two bodies along their common normal."""
    GEAR = "gear"
    """Pitch circles that roll on one another."""
    BELT = "belt"
    """A belt or chain that runs with two rims."""
    RACK = "rack"
    """A rack that moves with the rim of its gear."""
    SCREW = "screw"
    """A nut that moves by the pitch for each turn."""
    PARTING = "parting"
    """The rate at which the distance of two points grows."""
    COMPONENT = "component"
    """The component of a point's velocity along the load that acts on it."""


class Equation(NamedTuple):
    """``left = right``."""

    left: Formula
    right: Formula


@frozen
class Step:
    """One numbered step: the rule, the points and link it is applied to, what it gives.

    ``subject`` are names of the drawing: for LEVER and ARM the pivot first, then the points;
    for PROJECTION the two ends of the rod; for SLOT and CONTACT the pin and the body, for GEAR
    and BELT the two pivots, for RACK the pivot and the rack, for PARTING the two points; for
    TOGETHER the links involved; for COMPONENT the point and the load, ``V_A_P`` being the
    speed of A along P.
    ``relations`` is what the rule says; ``results`` the same solved for the new speeds.
    """

    rule: Rule
    subject: tuple[str, ...]
    relations: tuple[Equation, ...]
    results: tuple[Equation, ...]


@frozen
class PowerTerm:
    """The power of one load: ``times · load · speed``; ``speed`` is signed along the load."""

    load: str
    point: str
    times: Formula
    speed: Formula


@frozen
class Derivation:
    """The velocity steps, the power equation (or several, at mobility m), the results."""

    steps: tuple[Step, ...]
    terms: tuple[PowerTerm, ...]
    balances: tuple[Equation, ...]
    results: tuple[Result, ...]
