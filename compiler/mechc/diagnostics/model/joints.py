"""Messages for links, joints and geometry (E24x)."""

from collections.abc import Iterable, Sequence

from ...source import Span
from ..diagnostic import Message, Related, coded


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
    hint = "remove one" if corner else "write length and direction in one: AB = l @ alpha"
    return Message(span, f"{points} is given twice", hint, (Related(first, "given here first"),))


@coded("E245")
def length_not_positive(span: Span, points: str, value: str) -> Message:
    """A length is zero or negative.

    The direction says which way a vector points, so its length is positive. To reverse
    it, exchange its points or turn the direction by 180 deg.

        AB = -40 mm @ 0 deg       # wrong
        BA = 40 mm @ 0 deg        # right
    """
    hint = "a vector is reversed by exchanging its points"
    return Message(span, f"the length of {points} is {value}, expected a positive one", hint)


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
    """The number of copies is not a whole number of at least two.

    copies 3 sharing A       # right
    copies 1/2 sharing A     # wrong
    """
    return Message(span, f"the number of copies is a whole number from 2 on, found {found}")


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


def driven_by_points(name: str) -> str:
    """Return the hint at a drive that names a point or a load."""
    return f"{name} is no parameter; a link is driven by its points: drive OA from …"


@coded("E291")
def slides_in_itself(at: Span, point: str, body: str) -> Message:
    """A pin slides along a body that it belongs to, so it cannot move there.

    The pin belongs to one body and slides along another::

        link OC
        link AB
        slot B in OC         # right: B is of AB
        slot C in OC         # wrong
    """
    return Message(
        at,
        f"point {point} belongs to {body} and cannot slide along it",
        "name a pin of another body",
    )


@coded("E292")
def wheel_without_pivot(at: Span, what: str) -> Message:
    """A gear, a pulley or a screw turns about a pin on the ground.

    ::

        pivot O1
        link O1A
        gear O1 r1, O2 r2
    """
    return Message(
        at, f"{what} turns about no pivot, expected a pin on the ground", "add a `pivot` line"
    )


@coded("E293")
def wheel_of_several(at: Span, centre: str, links: Sequence[str], arm: str) -> Message:
    """A wheel is fixed to the one link on its centre; here there is none, or there are several.

    The arm that carries both wheels does not count. ``on`` tells which link is meant::

        pivot O1
        link O1A             # the gear on O1 turns with it
        link O1B
        gear O1 r1, O2 r2            # wrong: with O1A or with O1B?
        gear O1 r1 on O1A, O2 r2     # right
        gear O1 r1 on ground, A r2   # right: a gear that stands still
    """
    named = ", ".join(links)
    count = f"carries {named}" if named else "carries no link"
    beside = f" beside the arm {arm}" if arm else ""
    return Message(
        at,
        f"point {centre} {count}{beside}, expected one link to which the wheel is fixed",
        f"say which turns with the wheel: `on {links[0]}`" if links else "add its `link` line",
    )


@coded("E266")
def joint_of_another(at: Span, point: str, link: str, moves: str) -> Message:
    """A wheel, or a block in a slot, is fixed to a link that does not have its point.

    ::

        link OS "sun"
        link OA "arm"
        link AB "planet"
        gear O r1 on AB, A r2        # wrong: AB does not reach O
        gear O r1 on OS, A r2        # right

        slot B in OC guiding AD      # wrong: AD does not have B
        slot B in OC guiding BD      # right: BD slides along OC and turns with it
    """
    return Message(
        at,
        f"{point} is no point of {link}, expected a link on {point}",
        f"name the link that {moves}",
    )


@coded("E267")
def no_arm(at: Span, first: str, second: str) -> Message:
    """The centres of two wheels keep their distance: pivots, or points of one link, the arm.

    A wheel's own link is not the arm, since the wheel turns against it::

        link OA "arm"
        link OS "sun"
        link AB "planet"
        gear O r1 on OS, A r2          # right: OA carries both
        gear O r1 on OS, B r2          # wrong: no link carries O and B
    """
    return Message(
        at,
        f"no arm carries {first} and {second}, expected two pivots, or a link through both that is "
        "neither wheel",
        f"add the arm: `link {first}{second}`",
    )


@coded("E268")
def several_arms(at: Span, first: str, second: str, links: Iterable[str]) -> Message:
    """Two links carry the centres of the same wheels, which makes one body of them.

    ::

        link OA
        link OAB             # wrong beside OA
        gear O r1 on OS, A r2
    """
    return Message(
        at,
        f"{' and '.join(links)} carry both {first} and {second}, expected one arm",
        "make one link of them",
    )


@coded("E294")
def radius_not_positive(at: Span, shown: str) -> Message:
    """A radius or a pitch is zero or negative. A rack's may be negative: it lies on the left."""
    return Message(at, f"expected a positive length, found {shown}", "check the value")


@coded("E295")
def rack_without_guide(at: Span, point: str) -> Message:
    """A rack or a screw moves a point along its guide, and this point has none.

    The point is a slider, or belongs to a ``slide``.

    ::

        slider A along x
        rack A on O r
    """
    return Message(
        at,
        f"point {point} is no slider, so it has no guide to move along",
        f"add `slider {point} along x`",
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


@coded("E298")
def wheels_across_the_mirror(at: Span, first: str, second: str, are_twins: bool) -> Message:
    """A pair of wheels joins the two halves of a mirrored mechanism.

    The mirror by itself turns a link and its twin oppositely and equally fast, as equal
    gears or a crossed belt between them do, so such a pair adds nothing::

        gear O r, O' r                 # wrong: leave it out
        mirror across y sharing K

    Any other pair across the line needs both halves described.
    """
    left_out = "leave the pair out: the mirror turns a link and its twin oppositely already"
    return Message(
        at,
        f"the wheels on {first} and {second} join the halves of the mirror",
        left_out if are_twins else "describe both halves, without the mirror",
    )


@coded("E236")
def wheels_overlap(span: Span, pivots: str, apart: float, radii: float) -> Message:
    """The wheels of a belt stand where they overlap.

    A belt runs round both wheels in one plane, so that their pivots are farther apart than
    the sum of their radii::

        pivot O at (0, 0)
        pivot Q at (60 mm, 0)
        belt O 40 mm, Q 30 mm     # wrong: 70 mm
        belt O 20 mm, Q 30 mm     # right
    """
    message = f"the wheels on {pivots} are {apart * 1000:.7g} mm apart and overlap"
    hint = f"their radii make {radii * 1000:.7g} mm: are they diameters?"
    return Message(span, message, hint)


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
