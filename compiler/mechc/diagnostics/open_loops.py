"""Words of the pose stage for what keeps a loop from closing: too little given, or out of reach."""

import math
from collections.abc import Iterable, Sequence

from ..base.named import NamedTuple
from ..source import Span
from ..units import ANGLE, Dimension
from .diagnostic import Message, coded
from .syntax import listed


@coded("E312")
def pivot_without_place(at: Span, pivot: str, other: str, own: str, prefix: str) -> Message:
    """A pivot has no place, so no loop closes through it.

    With lengths and a ``drive`` the directions follow from loops, and a loop goes over the
    ground from one pivot to the next::

        pivot O                      # wrong: where is O, seen from C?
        pivot C at (100 mm, 0 mm)

        pivot O at (0 mm, 0 mm)      # right; or a vector, OC = (100 mm, 0 mm)
        pivot C at (100 mm, 0 mm)

    Of a part that is joined the pivot's ``own`` name, in its file, is proposed. Whoever does not
    write that file joins the pivot to one that has a place here::

        pivot D at (0 mm, 210 mm)
        use toggle as T joining T.E = D, T.B = B
    """
    join = f", or join it to a pivot that has a place here: `joining {prefix}.{own} = …`"
    seen = f", seen from {other}" if other else ""
    return Message(
        at,
        f"{pivot} has no place{seen}, and no loop closes through it",
        f"write where it is, as in `pivot {own} at (100 mm, 20 mm)`{join if prefix else ''}",
    )


@coded("E313")
def length_without_value(at: Span, name: str) -> Message:
    """A length in a loop has no value, so the directions of the loop do not follow.

    ::

        param a: length                    # wrong: how far does OA = a @ phi reach?
        param a in 30 mm .. 50 mm          # wrong: a range is no value
        param a = 40 mm in 30 mm .. 50 mm  # right
    """
    return Message(
        at,
        f"{name} has no value, and a loop needs it to close",
        f"give it one: `param {name} = 40 mm`",
    )


@coded("E344")
def angle_without_value(at: Span, name: str, inside: str) -> Message:
    """An angle in a loop has a range and no value, and the loop does not determine it.

    Behind a drive a loop gives the angles that have no value. A five-bar linkage needs one
    of them as a second input::

        param psi in 70 deg .. 90 deg            # wrong: a range is no value
        param psi = 75 deg in 70 deg .. 90 deg   # right
    """
    return Message(
        at,
        f"{name} has no value, and the loops do not determine it",
        f"give it one: `param {name} = {inside}`",
    )


@coded("W303")
def range_of_found(at: Span, name: str) -> Message:
    """A loop gives a parameter its value along the drive, and its range holds nothing there.

    ::

        param psi in 70 deg .. 90 deg     # warned of
        param psi: angle                  # right: CB = c @ psi follows from the drive
        require 70 deg < psi < 90 deg     # where it must stay within
    """
    message = f"a loop gives {name} its value, and its range bounds nothing"
    return Message(at, message, f"declare it without a range: `param {name}: angle`")


@coded("E314")
def guide_without_line(at: Span, slider: str, through: str) -> Message:
    """A guide has a direction and no line, so no loop closes through its slider.

    ::

        slider B along x             # wrong: on which line does B run?
        slider B along x through A   # right
    """
    return Message(
        at,
        f"the guide of {slider} has a direction and no place, and no loop closes through it",
        f"write `slider {slider} along … through {through}`",
    )


@coded("E315")
def inputs_missing(at: Span, points: Sequence[str], missing: int, guided: str = "") -> Message:
    """The loops leave more open than the drive gives: the linkage needs more inputs.

    A loop determines two directions or places. A five-bar linkage has one direction more
    than its loop determines, so it needs two inputs::

        OA = a @ phi
        AB = b
        BD = b
        CD = a               # wrong: three directions are open, the loop determines two
        CD = a @ psi         # right: the second input

    A link that a block guides (``slot B in OC guiding BD``) keeps its angle to the slot, which
    has to be given: ``angle OBD = 90 deg``.
    """
    several = "inputs are" if missing > 1 else "input is"
    names = ", ".join(points)
    if guided:
        hint = f"give the angle that the slot keeps, as in `angle {guided} = 90 deg`"
    else:
        hint = f"give {_counted(missing)} of them, as in `{points[-1]} = … @ psi`"
    return Message(
        at,
        f"the directions of {names} are open, and the loops leave {_counted(missing)} of them"
        f" undetermined: {_counted(missing)} more {several} needed",
        hint,
    )


def _counted(number: int) -> str:
    words = ("none", "one", "two", "three", "four")
    return words[number] if number < len(words) else str(number)


@coded("E316")
def directions_in_a_cycle(at: Span, points: Sequence[str]) -> Message:
    """Directions are given by one another, all the way round.

    ::

        OB = l @ BK
        BK = l @ OB          # wrong: each is given by the other
        OB = l @ alpha       # right
    """
    message = (
        f"the directions of {' and '.join(points)} are given by one another, none by an angle"
        if len(points) > 1
        else f"the direction of {points[0]} is given by itself"
    )
    return Message(at, message, f"give one of them, as in `{points[0]} = … @ alpha`")


@coded("E317")
def angle_not_found(at: Span, name: str, drive: str) -> Message:
    """An angle has no value, and no loop finds it, while a drive is to move the mechanism.

    A parameter without a value is found by the loop that it closes. Without such a loop it
    is a free symbol, which cannot be where something else drives::

        param psi: angle             # wrong: no loop gives it
        CB = @ psi

        param psi = 40 deg           # right, if it is given
        CB = l                       # right: a length, so that the loop closes
    """
    return Message(
        at,
        f"{name} has no value, and no loop that {drive} drives finds it",
        f"give it a value, as in `param {name} = 40 deg`, or give the lengths of its loop",
    )


# ------------------------------------------------------------------------- out of reach


class AssemblyRange(NamedTuple):
    """A part of the drive's stroke, in SI, its dimension, and its ends as formulas if known."""

    low: float
    high: float
    dimension: Dimension
    low_exact: str = ""
    high_exact: str = ""


@coded("E309")
def cannot_assemble(
    at: Span,
    loop: str,
    drive: str,
    stretches: Iterable[AssemblyRange],
    lengths: Sequence[str] = (),
    is_searched: bool = False,
) -> Message:
    """With the lengths given, a loop cannot be closed at the default pose.

    A triangle needs each side to be shorter than the other two together, a rod to reach
    its guide::

        AC = 100 mm @ 0 deg
        AB = 30 mm
        CB = 40 mm           # wrong: 30 mm + 40 mm do not reach over 100 mm

    With a ``drive`` the message says over which part of its stroke the loop closes; where
    one side of a triangle turns with it, the ends are arc cosines of lengths, which the
    hint gives, beside the lengths that may be wrong instead. A loop that closes at one value alone
    has a condition too many. Groups of class III and higher are closed by iteration from many
    starts: where it finds nothing there may still be a closure.
    """
    known = list(stretches)
    where = f"; it closes for {drive} {' and '.join(map(_stretch, known))}"
    never = f", nor anywhere along {drive}" if drive else ""
    change = f", or change {listed(lengths)}" if lengths else ""
    move = f"move the default of {drive} there{change}{_limits(drive, known)}"
    if known and not any(map(_is_long, known)):
        move = f"{drive} cannot move the loop: leave a length or an angle of it open"
    what = "is not closed by iteration" if is_searched else "cannot be assembled"
    return Message(
        at,
        f"the loop {loop} {what} at the default pose{where if known else never}",
        move if known else "change the lengths so that they reach",
    )


@coded("E340")
def out_of_reach(at: Span, loop: str, drive: str, is_followed: bool) -> Message:
    """The drive of a drawn mechanism is set to where a loop does not close.

    ``-D phi_OA=30deg`` moves a mechanism from where it is drawn; ``mechc stroke`` shows
    how far it can go. Where a loop is closed by iteration, its closure is followed from the
    drawing: others may lie beyond its end.

        drive OA from 10 deg to 80 deg
    """
    what = "is closed by no pose reached from the drawing" if is_followed else "cannot be assembled"
    message = f"the loop {loop} {what} with {drive} as it is set"
    return Message(at, message, "set it nearer to where it is drawn")


@coded("E348")
def loop_holds_fast(at: Span, loop: str) -> Message:
    """Links by the places of their pins hold one another, so that the drive cannot move them.

    The loop closes where it is drawn, and nowhere else: it has a link more than its pins leave
    room for, as a rod across two links that others have joined already::

        link CBD
        link EFG
        link DF
        link BF                     # wrong: F is held by E and D already
    """
    message = f"the links of the loop {loop} hold one another where they are drawn: nothing moves"
    return Message(
        at, message, "leave out a link or a guide of the loop; links in parallel need exact places"
    )


ONE_POSE = 1e-7
"""Ends of a stretch that differ by less than this part are one pose: a root has half the digits."""


def _is_long(stretch: AssemblyRange) -> bool:
    """Return whether a stretch is more than one pose, by more than rounding."""
    return stretch.high - stretch.low > ONE_POSE * max(abs(stretch.low), abs(stretch.high))


def _stretch(stretch: AssemblyRange) -> str:
    unit, size = ("deg", math.pi / 180) if stretch.dimension == ANGLE else ("mm", 1e-3)
    if not _is_long(stretch):
        return f"at {stretch.low / size:.6g} {unit} alone"
    low, high = _inside(stretch.low / size, stretch.high / size)
    return f"from {low} to {high} {unit}"


MOST_CUT_OFF = 0.005
"""The part of a stretch that rounding may leave out at an end."""

MOST_PLACES = 10
"""So many decimals an end of a stretch has at most."""


NOISE = 1e-10
"""The part of a stretch by which rounding may put its end off a round number."""


def _inside(low: float, high: float) -> tuple[str, str]:
    """Return both ends of a stretch with few decimals, rounded so that they lie in it.

    >>> _inside(180.6976931, 224.7463187), _inside(100.00000000000001, 280.0)
    (('180.7', '224.7'), ('100', '280'))
    """
    cut_off, rounding = MOST_CUT_OFF * (high - low), NOISE * (high - low)
    for places in range(MOST_PLACES):
        step = 10.0**-places
        first = math.ceil((low - rounding) / step) * step
        final = math.floor((high + rounding) / step) * step
        if max(first - low, high - final) <= cut_off:
            return f"{round(first, places):.10g}", f"{round(final, places):.10g}"
    return f"{low:.10g}", f"{high:.10g}"


def _limits(drive: str, stretches: Iterable[AssemblyRange]) -> str:
    """Return the shortest formulas of ends, two at most, behind a semicolon."""
    found = {f for s in stretches for f in (s.low_exact, s.high_exact) if f}
    shown = sorted(sorted(found, key=lambda f: (len(f), f))[:2])
    return f"; {drive} ends at " + " and ".join(shown) if shown else ""
