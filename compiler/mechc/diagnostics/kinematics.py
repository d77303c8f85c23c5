"""Words of the kinematics stage: mobility, redundancy, branch points."""

from collections.abc import Sequence

from ..source import Span
from .diagnostic import Message, coded
from .syntax import listed


@coded("E401")
def nothing_can_move(parts: Sequence[str], at: Span) -> Message:
    """The constraints leave no motion: mobility 0.

    Virtual power needs something that moves. Three rods in a triangle, a link with two
    pivots, or a point guided in two directions are locked::

        pivot O
        pivot C
        link  OAC            # wrong: two pivots hold the link

    Take a pivot, a guide or a rod away, or check that each rod is written between the
    points it really joins. A truss or a frame that is meant to stand has no k; the forces at
    its joints and along its rods can be asked for::

        find N_AC, R_A
    """
    if not parts:
        return Message(at, "nothing can move: no link or slider is described", "add a link")
    held = f"{listed(parts, 'and')} hold one another" if len(parts) > 1 else f"{parts[0]} is held"
    return Message(
        at,
        f"nothing can move: {held}, expected a mobility of 1 or more",
        "look for a link with two pivots, a point with two guides, or a rod too many",
    )


@coded("E402")
def asked_of_a_frame(at: Span, name: str) -> Message:
    """A ratio, a load or a speed is asked of a truss or a frame, in which nothing moves.

    Virtual power gives how loads balance in a motion. Where there is none every load is borne
    by the joints, whatever the others are::

        find k = P/F         # wrong: P does not follow from F
        find N_AC, R_A       # right: what the loads do to the joints
    """
    return Message(
        at,
        f"nothing moves, so no balance of loads gives {name}: mobility 0",
        "is a guide or a rod one too many? Of a frame ask for forces at joints, R_O or N_AB",
    )


@coded("E403")
def friction_in_a_frame(at: Span) -> Message:
    """Friction is given in a truss or a frame, in which nothing slips.

    Where bodies slip friction resists, and the sense of the motion decides its direction. In
    a frame it may be anything up to its bound, so that it changes no force for certain.
    """
    return Message(
        at, "nothing moves, how friction acts is undetermined: mobility 0", "leave it out"
    )


@coded("E841")
def too_many_motions(at: Span, motions: int, limit: int) -> Message:
    """So much moves independently that a joint or a guide must have been forgotten.

    Every speed is computed for every independent motion, which takes time and memory for
    thousands of them. A mechanism of mobility m has m loads to be found; no clamp, press
    or gripper has more than a handful.
    """
    return Message(
        at,
        f"the mechanism has {motions} independent motions, expected at most {limit}",
        "do rods lack a guide, or links a second pin?",
    )


@coded("E404")
def loose_end_of_telescope(at: Span, telescope: str, point: str) -> Message:
    """A load acts on an end of a telescope that is on nothing else.

    Nothing says how that end moves, so that its velocity cannot be asked for either. That of
    a cylinder is on a pivot or on a link::

        telescope CB
        actuator P between C and B
        C at (300 mm, 0 mm)           # wrong: a place alone holds nothing
        pivot C at (300 mm, 0 mm)     # right
    """
    return Message(
        at,
        f"{point} is an end of telescope {telescope} alone, expected a pivot, slider or link there",
        f"hold it, `pivot {point} at (0 mm, 0 mm)`, or name the link that carries it",
    )


@coded("W401")
def redundant_constraint(at: Span, what: str) -> Message:
    """A constraint follows from the others, so it may be left out.

    A second parallel bar, or a guide for a point that moves so anyhow, is consistent but
    redundant. k is not changed by it; the reactions of the redundant parts can't be found
    by statics alone.
    """
    return Message(
        at,
        f"{what} is redundant: what it demands follows from the other constraints",
        "leave it as it is, if the mechanism has it: k is the same with it and without it",
    )
