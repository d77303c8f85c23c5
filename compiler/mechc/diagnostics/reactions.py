"""Words of forces at joints: those that equilibrium leaves open, and loads found from them."""

from collections.abc import Sequence

from ..source import Span
from .diagnostic import Message, coded
from .syntax import listed


@coded("E509")
def reaction_undetermined(at: Span, result: str) -> Message:
    """A force at a joint is not determined by equilibrium.

    Where a mechanism is held more often than it needs (a redundant bar, two guides on one
    line) the sums of forces and moments leave open how the joints share the load; that
    depends on clearances and on how the parts bend.
    """
    message = f"equilibrium leaves {result} open: the mechanism is held more than once there"
    return Message(at, message, "leave the redundant bar or guide out, or ask for another force")


@coded("E595")
def which_load_follows(at: Span, result: str, loads: Sequence[str], number: int) -> Message:
    """A force at a joint is asked for, and nothing says which load follows from the others.

    The loads on a mechanism that moves are in a ratio to one another: one of them is as large
    as the others make it. A force at a joint follows from those that are given, and with friction
    the load that follows is the one that drives.

    ::

        force P at B along x
        force F at K along -y
        find R_O               # wrong: by P, or by F?

        find P                 # right: P follows from F
        find R_O

    A load whose size is given, as by `let F = 2 kN`, follows from nothing.
    """
    named = ", ".join(loads)
    follow = "one of the loads follows" if number == 1 else f"{number} of the loads follow"
    return Message(
        at,
        f"{follow} from the others, nothing says which of {named}: {result} is not determined",
        "write `find` for the load that follows, or give the others a size with `let`",
    )


@coded("E596")
def nothing_holds(at: Span, result: str, needed: int, found: int) -> Message:
    """A force at a joint is asked for, and no load is left to hold a mechanism that can move.

    A load whose size is given, by `let` or by a mass, holds nothing: the mechanism would move
    under it. As many loads as it has degrees of freedom are left open, and follow from the
    others::

        link OG
        weight W mass 2 kg at G
        find R_O               # wrong: what holds the lever?

        torque M on OG         # right
        find R_O
    """
    return Message(
        at,
        f"{result} is not determined: {needed} of the loads must be open to hold the mechanism, "
        f"found {found}",
        "add the load that holds it, or leave out its size",
    )


@coded("E512")
def transmission_presses(at: Span, point: str, has_friction: bool) -> Message:
    """The force on the pin of a gear, a pulley or a screw is asked for, or its friction.

    What the teeth pass on presses across the line of centres, a belt was tightened before
    it ran, and a screw's thrust is out of the plane: the description states none of them. A
    rack presses along its guide; its wheel's pivot can be asked about. The same goes for an arm
    that carries the centres of wheels.

        gear O1 20 mm, O2 40 mm
        find R_O1                                # wrong
        friction pin O1 0.1 diameter 10 mm       # wrong
        friction gear O1 0.02                    # right: what the teeth lose
        friction pin A 0.1 diameter 10 mm        # right: pin by pin, O1 left out
    """
    message = (
        f"the force on pin {point} is needed, and which way a gear, belt or screw presses there "
        "is undetermined"
    )
    hint = f"give friction pin by pin, and leave {point} out"
    if not has_friction:
        hint = "ask for the force at a pin that no gear, belt or screw presses"
    return Message(at, message, hint)


@coded("E515")
def found_from_itself(at: Span, name: str, load: str, through: Sequence[str]) -> Message:
    """A formula rests on loads each of which is found from the other.

    ``find P`` says what P is for a given F, and ``find F`` what F is for a given P. Nothing
    gives either a value, so neither has a formula that rests on both. The same goes for a load
    whose value is written with the load that is to be found from it::

        find P
        find F
        let q = P + F      # wrong: neither P nor F is given
        let q = 2*P        # right: a formula in F
        let F = 2 kN       # … or a number
    """
    by = listed(through, "and")
    return Message(
        at,
        f"'{name}' has no value: {load} is found from {by}, and {by} from {load}",
        f"leave out `find {load}`, so that {load} is given",
    )
