"""Messages for drives that are held (E525 to E527)."""

import math

from ...source import Span
from ..diagnostic import Message, Related, coded


@coded("E525")
def cannot_hold(at: Span, name: str, drawn: tuple[str, float] | None = None) -> Message:
    """Several drives: the first one moves, and what the other ones hold is undetermined.

    A drive is held by making fast what it moves: the direction of a link on a pivot, the
    angle between two links with a common pin, the length of a telescope, the place of a slider::

        OA = a @ phi
        AB = b @ psi            # wrong: AB turns as the loop demands, psi is no angle of a drive
        AB = b @ phi + psi      # right: psi is the angle between OA and AB
        drive phi from 0 deg to 90 deg
        drive psi

    In a drawn mechanism such an angle is given besides, ``param psi = 137 deg`` and ``angle OAB =
    psi``: the direction of a link that hangs on another one is no angle between the two.
    """
    hint = (
        "leave it out, for one degree of freedom has one drive; of several each is the direction "
        "of a link on a pivot, or an angle between two links"
    )
    if drawn:
        angle = f"'param psi = {math.degrees(drawn[1]):.4g} deg', 'angle {drawn[0]} = psi'"
        hint = f"if it is one of several, drive an angle between two links: {angle}, 'drive psi'"
    return Message(
        at,
        f"the drive {name} cannot be held: found no link on a pivot, two links with a common "
        "pin, telescope or slider that it moves",
        hint,
    )


@coded("E526")
def driven_twice(at: Span, name: str, first: Span) -> Message:
    """Two lines name the same drive.

    Of several drives the first one moves, the others are held at their values::

        drive phi from 0 deg to 90 deg
        drive phi from 0 deg to 45 deg     # wrong
        drive psi from 0 deg to 45 deg     # right: another one, held
    """
    return Message(
        at,
        f"{name} drives already, expected another coordinate",
        "leave one of the two lines out",
        (Related(first, "it is the drive here"),),
    )


@coded("E527")
def held_by_what(at: Span, name: str, drive: Span) -> Message:
    """A force at a joint, or friction, while a drive is held by what the description leaves open.

    A motor holds a link by a couple, a lock at its rim by a force: k is the same, the forces in
    the pins are not. A telescope and a slider hold by themselves::

        drive phi from 0 deg to 90 deg
        drive psi                          # held
        find k = M/F                       # right
        find R_O                           # wrong
        friction pins f diameter d         # wrong

    Without drives each motion has a load that holds it, and so have the joints::

        torque T on AB                     # what holds the second link
        find M, T
        find R_O                           # right
    """
    return Message(
        at,
        f"this rests on how {name} is held, expected a ratio of loads or speeds without friction",
        "leave the drives out, and find the torque that holds the other link, too",
        (Related(drive, "held here"),),
    )
