"""Messages for links, joints and geometry (E24x)."""

from collections.abc import Sequence

from ...source import Span
from ..diagnostic import Message, Related, coded, used_at
from ..syntax import listed


@coded("E240")
def pivot_and_slider(span: Span, point: str, first: Span) -> Message:
    """A point is both a pivot and a slider.

    A pivot stands still; a slider moves along its guide.

        pivot  A
        slider A along x     # wrong
    """
    related = (Related(first, "the other statement"),)
    return Message(span, f"point {point} is both a pivot and a slider", "remove one", related)


@coded("E241")
def joint_again(span: Span, what: str, point: str, first: Span) -> Message:
    """The same point is declared as a pivot, or as a slider, twice.

    pivot O
    pivot O     # wrong
    """
    related = (Related(first, "it stands here first"),)
    return Message(span, f"{what} {point} is declared twice", "remove one", related)


@coded("E242")
def link_again(span: Span, points: str, first: Span) -> Message:
    """Two links go through the same points.

    Two bodies pinned together at two points are one body.

        link OBA
        link ABO     # wrong
    """
    related = (Related(first, "the same points"),)
    return Message(span, f"a second link through the points {points}", "remove one", related)


@coded("E243")
def guide_through_moving_point(span: Span, point: str) -> Message:
    """A slider's guide is fixed to the ground, but is drawn through a point that is not.

    The point behind ``through`` is a pivot, or a place.

        slider A along x through B             # wrong where B is on a moving link
        slider A along x through O             # right where O is a pivot
        slider A along x through (0, 5 mm)     # right
    """
    message = f"a guide is fixed to the ground, but point {point} is no pivot"
    return Message(span, message, f"declare 'pivot {point}', or give the place: through (x, y)")


@coded("E244")
def vector_again(span: Span, points: str, corner: bool, first: Span) -> Message:
    """The vector between two points, or the angle between three, is given twice.

    ``AB`` and ``BA`` are the same vector up to its sign; all that is known of it stands
    in one line.

        AB = 40 mm
        AB = @ alpha             # wrong
        AB = 40 mm @ alpha       # right
    """
    both = "leave one of the two out, or write length and direction in one: AB = l @ alpha"
    hint = "remove one" if corner else both
    return Message(span, f"{points} is given twice", hint, (Related(first, "given here first"),))


@coded("E245")
def length_not_positive(span: Span, points: str, value: str, cause: Span) -> Message:
    """A length is zero or negative.

    The direction says which way a vector points, so its length is positive. To reverse
    it, exchange its points or turn the direction by 180 deg.

        AB = -40 mm @ 0 deg       # wrong
        BA = 40 mm @ 0 deg        # right
    """
    reversible = value.startswith("-")
    hint = "a vector is reversed by exchanging its points"
    hint = hint if reversible else "points at one place are one point; else give it a length"
    text = f"the length of {points} is {value}, expected a positive one"
    return Message(cause, text, hint, used_at(span, cause))


@coded("E246")
def turn_out_of_range(span: Span, points: str, value: str) -> Message:
    """An angle between vectors is more than a full turn.

    ``angle ABC`` is the turn at B from BA to BC, counter-clockwise, or clockwise where it
    is negative.

        angle ABC = 400 deg     # wrong
        angle ABC = 40 deg      # right
        angle CBA = -40 deg     # the same, turned the other way
    """
    return Message(
        span,
        f"angle {points} is {value}, expected -360 … 360 deg",
        "leave out full turns",
    )


@coded("E247")
def twin_declared(span: Span, twin: str, point: str, mirror: Span) -> Message:
    """A point is declared that ``mirror`` makes by itself.

    With a mirror, each point A that is not shared has a twin A' on the other side.

        link OA
        link OA'                              # wrong: made by the mirror
        mirror across 90 deg sharing O
    """
    related = (Related(mirror, f"this makes {twin} from {point}"),)
    return Message(
        span, f"point {twin} is the mirror twin of {point}", "describe one half", related
    )


@coded("E248")
def copies_not_whole(span: Span, found: str) -> Message:
    """The number of copies is not a whole number from two to a thousand.

    copies 3 sharing A       # right
    copies 1/2 sharing A     # wrong
    """
    message = f"the number of copies is a whole number from 2 to 1000, found {found}"
    return Message(span, message, "count all equal branches, the one described among them")


@coded("W240")
def idle_joint(span: Span, what: str, point: str) -> Message:
    """A pivot or slider holds no link and nothing uses it.

    pivot O
    pivot Q      # warned of: no link goes through Q
    link  OA
    """
    return Message(span, f"no link goes through {what} {point}", "is it mistyped?")


@coded("E288")
def assembly_of_wrong_points(at: Span, points: str, mode: str) -> Message:
    """An ``assembly`` names points that do not go with its word.

    Three points turn one way or the other; one point stands farther along its guide or
    farther back::

        assembly AB ccw       # wrong: two points have no turn
        assembly ABC ccw      # right
        assembly B forward    # right: B is on a guide
    """
    wanted = "three points" if mode in ("cw", "ccw") else "one point on a guide"
    return Message(
        at,
        f"'{mode}' is said of {wanted}, found {points}",
        "write `assembly ABC ccw` for a turn, `assembly B forward` for a place along a guide",
    )


@coded("E289")
def assembly_without_guide(at: Span, point: str) -> Message:
    """``forward`` and ``back`` are said of a point that no guide or slot holds.

    They tell the two places of a slider along its line apart::

        slider B along x through O
        assembly B forward
    """
    return Message(
        at,
        f"point {point} is on no guide, so it is neither forward nor back",
        "name three points that turn, such as `assembly ABC ccw`, or give the point a guide",
    )


@coded("E290")
def drive_depends(at: Span, name: str) -> Message:
    """The driving coordinate follows from other parameters, so nothing can drive it.

    The drive is what the stroke runs over, and everything else follows from it::

        param phi = 2*psi
        drive phi from 10 deg to 80 deg    # wrong
        drive psi from 5 deg to 40 deg     # right
    """
    return Message(
        at,
        f"the drive {name} follows from other parameters, expected an independent one",
        "drive a parameter that it follows from",
    )


def driven_by_points(name: str, is_guided: bool) -> str:
    """Return the hint at a drive that names a point, which a guide may lead, or a load."""
    if is_guided:
        return f"the place of {name} is driven by a parameter: {name} at (0 mm, s), drive s from …"
    return f"{name} is no parameter; a link is driven by its points: drive OA from …"


@coded("E291")
def slides_in_itself(at: Span, point: str, body: str) -> Message:
    """A pin slides along a body that it belongs to, so it cannot move there.

    The pin belongs to one body and slides along another::

        link OC
        link AB
        slot B in OC         # right: B is of AB
        slot C in OC         # wrong

    A line on the body is named by two points of it, ``slide EF along y`` and ``slot D in EF``.
    """
    return Message(
        at,
        f"point {point} belongs to {body} and cannot slide along it",
        f"name a pin of another body, or name {body} by other points than {point}",
    )


@coded("E297")
def slide_does_not_turn(at: Span, slide: str, first: Span) -> Message:
    """A couple, or an angular velocity, is asked of a body that only translates.

    A ``slide`` never turns: a couple on it does no work, its guide takes it, and its
    angular velocity is zero. Loads of a slide are forces at its points::

        slide WXY along x
        torque M on WXY            # wrong
        force  P at W along x      # right
    """
    return Message(
        at,
        f"{slide} only translates, expected a link that turns",
        f"let a force act at a point of {slide}, or declare it as a link",
        (Related(first, "declared as a slide"),),
    )


@coded("E341")
def rope_with_drive(at: Span, drive: Span) -> Message:
    """A rope stands in a mechanism that has a drive.

    The length of a rope is not given, so that where the points that it leads are does not
    follow from the drive. Forces and ratios of velocities need no drive::

        drive phi from 10 deg to 80 deg
        rope A, K along -y, B along y, H along -y     # wrong: leave the drive out
    """
    related = (Related(drive, "the drive"),)
    message = "a rope leads points whose places do not follow from the drive"
    return Message(at, message, "leave the drive out and describe one pose", related)


@coded("E342")
def fall_to_itself(at: Span, point: str) -> Message:
    """A fall of a rope ends at the point that it begins at.

    rope A, A along y, B along -y     # wrong
    rope A, B along -y                # right
    """
    message = f"a fall of the rope leads from {point} to itself, expected another point"
    return Message(at, message, f"name {point} once")


@coded("W207")
def pulleys_without_friction(at: Span, axles: Sequence[str]) -> Message:
    """Friction is given for pins on which the pulleys of a rope turn, and is not counted there.

    A rope has one tension in all its falls, so that its pulleys turn without resistance. Links
    on the same pins have their friction::

        rope A, K along -y, B along y, H along -y
        friction pins 0.1 diameter 20 mm          # not of the pulleys on K and B
    """
    return Message(
        at,
        f"the friction of pins leaves out the pulleys on {listed(axles, 'and')}",
        "results with friction are then those of links and guides alone",
    )


@coded("W241")
def guided_twice(at: Span, slide: str, point: str) -> Message:
    """A point of a slide is a slider as well.

    All points of a slide move along its direction, so that a guide of their own adds
    nothing where it is parallel, and locks the slide where it is not::

        slider W along x
        slide  WXY along x                # warned of: the slide guides W by itself
        slider W along x through O        # right: it says where the guide lies
    """
    return Message(
        at,
        f"slider {point} is a point of the slide {slide}, which guides it by itself",
        f"leave the slider {point} out",
    )
