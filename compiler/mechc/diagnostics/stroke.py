"""Messages for strokes (E59x)."""

import math
from collections.abc import Iterable, Sequence

from ..source import Span
from ..units import ANGLE, Dimension
from .diagnostic import Message, Related, coded
from .syntax import listed


@coded("E591")
def no_drive(
    span: Span, able: Sequence[str], unit: str, ranged: Sequence[str] = (), moves: bool = True
) -> Message:
    """A stroke was asked for, and the description names no driving coordinate.

    ::

        param phi = 30 deg
        drive phi from 10 deg to 80 deg

    Over the range of a parameter, ``mechc plot FILE --x phi`` shows results without a drive.
    A frame has no stroke: nothing moves in it.
    """
    if not moves:
        hint = "what `mechc check` gives of a frame are its forces"
        return Message(span, "nothing moves, so that there is no stroke", hint)
    message = (
        f"no driving coordinate is named, expected {listed(able)}" if able else "nothing drives"
    )
    example = able[0] if able else "phi"
    line = f"add a line such as `drive {example} from 10 {unit} to 80 {unit}`"
    plot = f"`mechc plot FILE --x {ranged[0]}` runs over its range; or " if ranged else ""
    return Message(span, message, f"{plot}{line}")


@coded("E592")
def no_stroke(span: Span, name: str) -> Message:
    """The driving coordinate has neither a stroke nor a range.

    ::

        drive phi                          # wrong, unless phi has a range
        drive phi from 10 deg to 80 deg    # right
    """
    return Message(
        span,
        f"the stroke of {name} has no ends, expected two",
        f"write `drive {name} from … to …`, or give {name} a range",
    )


@coded("E593")
def empty(span: Span, name: str) -> Message:
    """A stroke begins and ends at one place.

    ::

        drive phi from 10 deg to 10 deg    # wrong
        drive phi from 10 deg to 80 deg    # right
    """
    return Message(span, f"the stroke of {name} is empty", "give it two ends that differ")


@coded("E594")
def too_many_turns(span: Span, name: str, turns: float, most: int) -> Message:
    """A stroke goes round more often than can be looked at.

    Results repeat after a turn, and between the places that a stroke is looked at nothing
    may be missed::

        drive phi from 0 deg to 1e12 deg    # wrong
        drive phi from 0 deg to 360 deg     # right
    """
    message = f"the stroke of {name} is {turns:.3g} turns, expected at most {most}"
    return Message(span, message, "give it the turns after which everything repeats")


@coded("W593")
def beyond_range(span: Span, name: str, parameter: Span) -> Message:
    """A stroke goes beyond the range of the driving parameter.

    The range is what the parameter may be, the stroke what the drive runs over: one of the
    two is probably mistyped::

        param phi = 60 deg in 10 deg .. 80 deg
        drive phi from 10 deg to 120 deg         # warned of
    """
    message = f"the stroke of {name} goes beyond its range"
    related = (Related(parameter, "the range"),)
    return Message(span, message, "widen the range, or shorten the stroke", related)


@coded("W222")
def pose_left_out(span: Span, name: str, value: str) -> Message:
    """The mechanism is drawn, or given, in a pose that its stroke does not reach.

    Results are printed at that pose, and the closures of loops are those that follow from it,
    so that one of the two is probably mistyped::

        OA = 40 mm @ phi
        param phi = 120 deg
        drive phi from 10 deg to 80 deg      # warned of
    """
    message = f"the stroke leaves out the default pose, where {name} is {value}"
    return Message(span, message, "widen the stroke, or give a pose within it")


@coded("W594")
def not_assembled(
    span: Span,
    name: str,
    parts: Iterable[tuple[float, float]],
    dimension: Dimension,
    places: int,
    why: str,
) -> Message:
    """A loop does not close over a part of the stroke.

    There is no pose there, results are NaN, and the drive cannot run through. ``mechc stroke``
    shows where it ends, and what is singular there. The stroke is sampled: the ends of what is
    found are refined, a part narrower than the distance of two samples may be overlooked.
    Where a loop is closed by iteration, the closure is followed from the default pose: there may
    be others beyond its end, and iteration may find no pose although there is one::

        param phi = 60 deg
        drive phi from 10 deg to 80 deg     # warned of, if it closes from 54 deg on only
    """
    unit, size = ("deg", math.pi / 180) if dimension == ANGLE else ("mm", 1e-3)
    shown = " and ".join(f"from {a / size:.7g} to {b / size:.7g} {unit}" for a, b in parts)
    return Message(
        span,
        f"{_sentence(why)} for {name} {shown}, seen at {places} places",
        "shorten the stroke, or change the lengths",
    )


def _sentence(why: str) -> str:
    """Return why there is no pose as a sentence, what ``cannot be assembled`` with its subject."""
    return f"the mechanism {why}" if why.startswith("cannot") else why


@coded("W284")
def range_not_assembled(span: Span, name: str, low: str, high: str, why: str) -> Message:
    """The range of a parameter reaches to where the mechanism cannot be assembled.

    A loop does not close there, and code gives NaN. The ends of each range are looked at, the
    other parameters at their values. Where a loop is closed by iteration, its closure is
    followed from the default pose: others may lie beyond its end::

        param r = 50 mm in 30 mm .. 300 mm     # warned of: with a rod of 200 mm
        param r = 50 mm in 30 mm .. 150 mm     # right
    """
    parts = [f"below {low}"] * bool(low) + [f"above {high}"] * bool(high)
    message = f"within the range of {name}, {' and '.join(parts)}, {_sentence(why)}"
    return Message(span, message, "narrow the range, or change the lengths")


@coded("W591")
def direction_stays(span: Span, link: str, drive: str, guided: str = "") -> Message:
    """A link does not turn along the stroke as the joints make it turn.

    A direction that is given as an angle of its own stays where it is while the drive
    moves, and so the rows of the stroke are those of another mechanism::

        drive phi from 10 deg to 80 deg
        OA = a @ phi
        gear O r, Q R
        QB = b @ psi                         # wrong for a psi that stands still
        param psi = 40 deg - r/R*phi         # right: QB turns as the gears do

    Where rods lead the link, give their lengths and leave its direction out: mechc closes
    the loop. The guide of a slider has a place then::

        slider B along x                     # wrong: B would be drawn off its guide
        AB = b @ -20 deg
        slider B along x through O           # right
        AB = b
    """
    hint = f"leave its direction to a loop, or write it as a formula of {drive}"
    if guided:
        hint = f"give its length alone, and its guide a place: slider {guided} … through …"
    return Message(
        span, f"link {link} does not follow {drive} along the stroke as its joints demand", hint
    )


@coded("W592")
def link_bends(span: Span, link: str, angle: str, drive: str) -> Message:
    """Directions of a link are given so that an angle in it changes while the drive moves.

    A link is rigid. Along the stroke the rows would be those of another mechanism::

        link BMHE
        BM = l/2 @ 180 deg - phi
        BH = s @ phi                         # wrong: the angle MBH would be 180 deg - 2*phi
        BH = s @ 180 deg - phi               # right: H lies on BM
        angle MBH = 20 deg                   # right, too: an angle of the link
    """
    return Message(
        span,
        f"link {link} is rigid, but its angle {angle} changes with {drive}",
        f"let both directions turn alike, or give the angle: 'angle {angle} = …'",
    )


@coded("E597")
def no_path(name: str, known: Sequence[str], near: str) -> Message:
    """A path was asked for of what has none: no point and no link of that name has a place.

    A point has a path where vectors of known length lead to it from the origin, or from the
    first pivot where no pivot has a place.

    Wrong: ``mechc stroke crank_rocker --path C``, as its points are O1, A, B and O2
    Right: ``mechc stroke crank_rocker --path B --path AB``
    """
    expected = listed(known) if known else "a drive, and points in place"
    return Message(
        None,
        f"{name} has no path, expected {expected}",
        near or "name a point or a link, or ask for all with --path all",
    )
