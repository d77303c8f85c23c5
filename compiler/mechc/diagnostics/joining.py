"""Messages about mechanisms that become parts of another one (E569 to E579)."""

from collections.abc import Collection

from ..source import Span
from .diagnostic import Message, Related, coded, near_miss


@coded("E569")
def no_such_point(
    span: Span, point: str, where: str, known: Collection[str], heading: Span | None
) -> Message:
    """A point at which mechanisms are joined, or that is named of a part, is not there::

        use toggle_clamp as T joining T.X = B      # wrong: toggle_clamp has no point X
        use toggle_clamp as T joining T.H = B      # right

    On the left stands a point of what is used, on the right one of this file, or of a part above.
    """
    there = f"it has {', '.join(known)}" if known else "it has none"
    related = (Related(heading, "this is what is used"),) if heading else ()
    return Message(span, f"{where} has no point {point}", near_miss(point, known) or there, related)


@coded("E570")
def fixed_and_moving(span: Span, inside: str, outside: str, fixed: Span) -> Message:
    """A pin on the ground is joined to a point that moves, which could then move no more::

        pivot O
        link OA
        use toggle_clamp as T joining T.O = A      # wrong: O is fixed in toggle_clamp, A moves
        use toggle_clamp as T joining T.H = A      # right: both move

    A pivot may be joined to a pivot, where another point is joined besides.
    """
    related = (Related(fixed, "it is fixed here"),)
    message = f"{inside} of what is used is joined to {outside}, of which one is fixed, one moves"
    return Message(span, message, "join points that move", related)


@coded("E571")
def nothing_passes(span: Span, fixed: Span) -> Message:
    """Mechanisms are joined at pins on the ground only, so that neither moves the other::

    pivot O
    use toggle_clamp as T joining T.O = O             # wrong
    use toggle_clamp as T joining T.O = O, T.H = B    # right
    """
    related = (Related(fixed, "it is fixed here"),)
    message = "what is used is joined at fixed points only, through which nothing passes"
    return Message(span, message, "join a point that moves as well", related)


@coded("E572")
def no_such_part(span: Span, prefix: str, known: Collection[str]) -> Message:
    """A point is named of something that is no part of this mechanism.

    ``T.H`` is point H of what ``use … as T joining …`` joins. A line that joins to another part
    stands below that part. A quantity is written with an underscore: ``T_k``::

        use crank_slider as S
        use toggle_clamp as T joining T.H = S.B
        force F at T.E along -y
    """
    there = f"parts are {', '.join(known)}" if known else "join one: use NAME as T joining T.C = B"
    there += f"; a quantity of what is used is {prefix}_k" if not known else ""
    message = f"no mechanism is joined as {prefix!r} above"
    return Message(span, message, near_miss(prefix, known) or there)


@coded("E573")
def other_place(span: Span, inside: str, outside: str, there: Span, here: Span) -> Message:
    """Joined points are drawn at different places.

    The frame of what is used lies so that the first joined points that are both drawn coincide,
    or where ``at`` puts its origin, turned as ``turned`` says. Then all that are joined have to
    coincide::

        use "arm.mech" as T at (120 mm, 0 mm) turned 90 deg joining T.C = B
    """
    related = (Related(here, f"{outside} is drawn here"), Related(there, f"{inside} is drawn here"))
    message = (
        f"{inside} of what is used falls on another place than {outside}, to which it is joined"
    )
    return Message(span, message, "look at the places, `at` and `turned`", related)


@coded("E574")
def rests_on_what_stays(span: Span, load: str, behind: str, tied: Span) -> Message:
    """A load of what is used rests on one that stays behind.

    A force at a joined point stands for the neighbour, and stays behind, as do loads that
    ``without`` names. What is tied to one of them is named as well::

        use "jaw.mech" as J joining J.A = B without T     # force T = f*R, and R acts at A
    """
    related = (Related(tied, "it is tied here"),)
    message = f"{load} of what is used rests on {behind}, which stays behind"
    return Message(span, message, f"leave it behind, too: without {load}", related)


@coded("E575")
def not_there(span: Span, name: str, used: str, known: Collection[str]) -> Message:
    """What is to stay behind is no load and no parameter of what is used.

    ``without`` names loads, and parameters whose values a loop of the whole gives::

        use toggle_clamp as T joining T.H = B without F
    """
    there = f"it has {', '.join(known)}" if known else "it has none"
    message = f"{used} has no load and no parameter {name!r}"
    return Message(span, message, near_miss(name, known) or there)


@coded("E576")
def joins_no_other(span: Span, prefix: str) -> Message:
    """On one side of a joint stands a point of what is used, on the other one that is not.

    use toggle_clamp as T joining H = B        # wrong
    use toggle_clamp as T joining T.H = B      # right
    """
    message = "a joint is a point of what is used, and one of the rest"
    return Message(span, message, f"write the first with its prefix: {prefix}.C = B")


@coded("E577")
def joined_twice(span: Span, prefix: str) -> Message:
    """A point is joined to two points.

    Two points of one mechanism cannot become one by way of another mechanism::

        use toggle_clamp as T joining T.H = B, T.H = C     # wrong
    """
    return Message(span, f"a point of this joint of {prefix} is joined already", "take one out")


@coded("E578")
def only_of_a_whole(span: Span, found: Span) -> Message:
    """What is used has a line that can be said of a whole mechanism only.

    One half of a mirror, one of several copies, and one efficiency for all are none of a part.
    Write the part without the line, and the line where it is used::

        mirror across y sharing K
    """
    related = (Related(found, "it says so here"),)
    message = "what is used has a line that no part of a mechanism can have"
    return Message(span, message, "say it of the whole", related)


@coded("E579")
def guides_differ(span: Span, point: str, other: Span) -> Message:
    """Both mechanisms guide a joined point, in directions that are not written alike.

    The direction of a guide says which way is forward, so that x and -x are two.

    The guide of this file holds, and that of what is used stays behind where they are the same::

        slider B along x
        use "press.mech" as T joining T.K = B      # slider K along y: wrong
    """
    related = (Related(other, "what is used guides it here"),)
    return Message(
        span, f"the guides of {point} are directed differently", "turn one of them", related
    )


@coded("E909")
def part_without_joint(span: Span, word: str) -> Message:
    """Where a frame lies and what stays behind is said of a mechanism that is joined.

    use toggle_clamp as T at (100 mm, 0 mm)                    # wrong
    use toggle_clamp as T at (100 mm, 0 mm) joining T.H = B    # right
    """
    message = f"`{word}` is said of a mechanism that is joined, and this one is not"
    return Message(span, message, "join it: joining T.C = B")


@coded("E910")
def which_way_is_down(span: Span, gravity: Span) -> Message:
    """What is used has weights and says which way is down; the whole has to say so as well.

    gravity along -y
    use "arm.mech" as A joining A.C = B
    """
    related = (Related(gravity, "what is used says it here"),)
    message = "what is used has weights, and this file does not say which way they pull"
    return Message(span, message, "say it: gravity along -y", related)
