"""Messages for what goes wrong when a mechanism is drawn (E72x)."""

from .diagnostic import Message, coded

LACKING = frozenset({"E721"})
"""Codes that say that the machine lacks something: the description is not wrong."""


@coded("E720")
def nothing_to_draw() -> Message:
    """A picture of a mechanism that cannot be assembled at the values given, or has no points.

    A loop of given lengths is open there: two links of 20 mm do not bridge 50 mm, whatever
    their angles. Or the halves of a mirror do not meet on its line.

    Wrong: ``mechc draw crank_slider -D r=1mm -o k.svg`` where the rod is too short then
    Right: ``mechc draw crank_slider -o k.svg``
    """
    return Message(
        None,
        "there is no picture: expected points that can be assembled at these values, found none",
        "describe links and pivots, or set other values with -D",
    )


@coded("E721")
def no_library(what: str, extra: str, reason: str) -> Message:
    """A format needs a library that is not there.

    SVG, LaTeX and CSV need none. For PDF and PNG mechc asks typst, for Excel xlsxwriter, which no
    other output needs, so that they are not installed by themselves.

    Wrong: ``mechc draw clamp.mech -o clamp.png`` without it
    Right: ``pip install 'mechc[png]'`` before, or ``mechc draw clamp.mech -o clamp.svg``
    """
    return Message(
        None,
        f"{what} cannot be written: expected a library, found {reason}",
        f"pip install 'mechc[{extra}]'",
    )


@coded("E722")
def no_free_bodies() -> Message:
    """Free bodies of a description that asks for no load.

    Forces follow from the loads that a result speaks of. One of velocities alone speaks of
    none, so that there is nothing to draw on the bodies.

    Wrong: ``find v = V_B/V_A`` alone, and ``mechc draw FILE --bodies``
    Right: ``find k = P/F`` besides
    """
    return Message(
        None,
        "there are no free bodies: expected a result that speaks of a load, found none",
        "ask for one, as in find k = P/F, or draw the scheme without --bodies",
    )


@coded("E723")
def no_plans() -> Message:
    """Plans of a mechanism that stands still, and on which no force is asked for.

    The polygon of velocities needs a pose in which the drive moves the mechanism, those of
    forces need a result that speaks of a load. Here there is neither.

    Wrong: ``find v = V_B/V_A`` alone, at a dead centre, and ``mechc draw FILE --plans``
    Right: another pose, ``-D phi=30deg``, or ``find k = P/F`` besides
    """
    return Message(
        None,
        "there are no plans: expected points that move or forces on bodies, found none",
        "set another pose with -D, or ask for a result that speaks of a load",
    )
