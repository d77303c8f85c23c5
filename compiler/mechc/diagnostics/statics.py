"""Messages for what the referee finds: equilibrium of the free bodies against virtual power."""

import math
from collections.abc import Mapping

from ..source import Span
from ..units import ANGLE, NUMBER, Dimension, base_units
from .diagnostic import Message, coded

REPORT_IT = "this is a bug in mechc, not in the description: please report it with this file"

BUGS = frozenset({"E540", "E601", "E602", "E603"})
"""Errors that speak of mechc, not of the description; the command line ends with status 70."""


@coded("E601")
def methods_disagree(span: Span, result: str, power: float, statics: float) -> Message:
    """The two methods disagree.

    Every result is computed twice: as a formula by virtual power, and in numbers from the
    equilibrium of every link and pin, at the default pose and at three others. They differ
    here by more than rounding explains, so one of the two is wrong and nothing is emitted.

    There is nothing to fix in the description: this is a bug in mechc. Please report it,
    with the file. ``mechc check --verbose`` shows the poses and both numbers.
    """
    found = f"virtual power gives {result} = {power!r}, equilibrium of the free bodies {statics!r}"
    return Message(span, f"the two methods disagree: {found}; they should be equal", REPORT_IT)


@coded("E602")
def no_equilibrium(span: Span, result: str, reason: str) -> Message:
    """Virtual power gives a result where equilibrium gives none.

    A finite force ratio means that the loads can be balanced. At every pose that was tried
    the sums of forces and moments on the links and pins have no solution, or leave the
    load asked for open. One of the two methods has misread the mechanism, so nothing is
    emitted.

    This is a bug in mechc. Please report it, with the file.
    """
    message = f"{result} has a value by virtual power, but not by equilibrium: {reason}"
    return Message(span, message, REPORT_IT)


@coded("E603")
def pose_does_not_close(span: Span, what: str, gap: float) -> Message:
    """The mechanism does not stand as described.

    With the directions and lengths that were found for the pose, every point is put in its
    place once more, in numbers, and all that the description says of the geometry is
    measured. Something does not fit: a loop stays open, or a given length or angle is not
    kept. Formulas that rest on such a pose would be wrong, so nothing is emitted.

    There is nothing to fix in the description: this is a bug in mechc. Please report it,
    with the file.
    """
    message = f"the pose that was found does not fit: {what} is off by {gap:.3g} m, expected 0"
    return Message(span, message, REPORT_IT)


@coded("W601")
def not_checked(span: Span, result: str, reason: str, is_fixed: bool = False) -> Message:
    """A result could not be checked by the equilibrium of the free bodies.

    Each result is checked in numbers at the default pose and at poses drawn from the ranges
    of the parameters. Here no pose was found at which it has a finite value: the default
    pose breaks a ``require`` or is a dead centre, and so are all poses that were drawn.

    Wrong: a range outside the condition of use ::

        param alpha = 40 deg in 40 deg .. 80 deg
        require alpha < 30 deg

    Right: a range, and a default value, within it ::

        param alpha = 20 deg in 5 deg .. 30 deg
        require alpha < 30 deg
    """
    hint = "give the parameters values and ranges at which the mechanism can stand"
    if is_fixed:
        hint = (
            "there are no parameters, so there is no other pose to check it at: change the numbers"
        )
    return Message(span, f"{result} was not checked against equilibrium: {reason}", hint)


@coded("W602")
def several_balances(
    span: Span, result: str, value: float, pose: Mapping[str, tuple[float, Dimension]]
) -> Message:
    """With friction more than one force balances the loads, or none with less friction.

    Friction grows with the forces that press the joints, and these change with friction. Where it
    is large, or a dead centre near, a second balance may appear in which joints are pressed the
    other way, beyond a range in which the drive jams. The force that is given is one at which
    the mechanism slips, but nothing says that a drive which grows from nothing comes to it::

        param alpha = 89.99 deg       # the toggle is all but straight: a drive may stick
        param alpha = 85 deg          # right

    Keep away from such poses, or make friction smaller.
    """
    place = _placed(pose) or " at the default pose"
    return Message(
        span,
        f"{result} = {value:.6g}{place} is not the only force that balances with friction, or "
        "with less friction none does: the drive may stick before it",
        "move the values away from the dead centre, or make friction smaller",
    )


@coded("E604")
def contact_would_pull(
    span: Span,
    point: str,
    body: str,
    load: str,
    force: float,
    pose: Mapping[str, tuple[float, Dimension]],
) -> Message:
    """A contact would have to pull for the loads to balance, and bodies that touch only push.

    The normal of a contact is the direction in which the body pushes the point. Where
    equilibrium asks for the opposite, the bodies part and nothing is transmitted::

        contact A on WX normal 80 deg     # the wedge pushes A up
        force F at A along y              # wrong: F lifts A off the wedge
        force F at A along -y             # right

    Turn the normal where it was drawn the wrong way, or the load.
    """
    return Message(
        span,
        f"{body} would have to pull {point} with {-force:.4g} times {load}{_placed(pose)}, "
        "but a contact can only push",
        "turn the normal round if it points the wrong way, or else the load",
    )


@coded("E343")
def rope_would_push(
    span: Span,
    rope: str,
    load: str,
    force: float,
    pose: Mapping[str, tuple[float, Dimension]],
) -> Message:
    """A rope would have to push for the loads to balance, and a rope only pulls.

    Its tension pulls both ends of each fall towards each other. Where equilibrium asks for the
    opposite, the rope is slack and nothing is transmitted::

        rope A, K along -y, H along y
        force F at K along y              # wrong: F lifts the pulley out of the rope
        force F at K along -y             # right

    Turn the fall that was drawn the wrong way, or the load.
    """
    return Message(
        span,
        f"the {rope} would have to push with {-force:.4g} times {load}{_placed(pose)}, "
        "but a rope can only pull",
        "turn the direction of a fall round if it points the wrong way, or else the load",
    )


def _placed(pose: Mapping[str, tuple[float, Dimension]]) -> str:
    """Return `` at alpha = 30 deg``, nothing of a pose without parameters."""
    place = ", ".join(f"{name} = {_measured(*value)}" for name, value in pose.items())
    return f" at {place}" if place else ""


def _measured(value: float, dimension: Dimension) -> str:
    if dimension == ANGLE:
        return f"{math.degrees(value):.6g} deg"
    return f"{value:.6g} {'' if dimension == NUMBER else base_units(dimension)}".strip()


@coded("E540")
def friction_not_counted(at: Span, pin: str) -> Message:
    """Every pin is said to have friction, and one of them was left out: a bug in mechc.

    Free bodies are cut at every pin, and all that turn there are counted. One on which no
    friction acts was forgotten on the way from the description to the formula.
    """
    message = f"every pin is said to have friction, but none acts at {pin}"
    return Message(at, message, REPORT_IT)
