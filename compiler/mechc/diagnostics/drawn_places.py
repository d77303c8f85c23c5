"""Words for drawn places: points that are not where the rest of the description has them."""

import math

from ..source import Span
from .diagnostic import Message, Related, coded


@coded("E264")
def drawn_again(at: Span, point: str, first: Span) -> Message:
    """A point has two places.

    The drawing shows each point once; a pivot's place may stand in its own line::

        pivot O at (0 mm, 0 mm)
        O at (0 mm, 5 mm)        # wrong: O has a place
    """
    return Message(
        at, f"point {point} has a second place", "leave one out", (Related(first, "the first"),)
    )


@coded("E320")
def driven_not_drawn(at: Span, vector: str, point: str) -> Message:
    """A link is driven, and nothing says where it is at the default pose.

    ``drive OA`` turns the link OA, or extends the telescope OA, from where it is drawn::

        pivot O at (0 mm, 0 mm)
        link OA
        A at (20 mm, 35 mm)           # without this: wrong
        drive OA from 10 deg to 80 deg

    A parameter drives it just as well: ``OA = 40 mm @ phi`` and ``drive phi``.
    """
    message = f"'drive {vector}' needs the place of {point} at the default pose"
    return Message(at, message, f"add a line such as `{point} at (20 mm, 35 mm)`")


@coded("E321")
def drawn_together(at: Span, body: str, point: str, other: str, first: Span) -> Message:
    """Two points of one body are drawn at one place, so that no line leads from one to the other.

    link AB
    A at (20 mm, 35 mm)
    B at (20 mm, 35 mm)      # wrong

    Pins at one place that are two on paper are one point here: give them one name.
    """
    message = f"{point} and {other} of {body} are drawn at one place"
    return Message(at, message, "correct one of the two", (Related(first, f"{other} is here"),))


@coded("E322")
def drawn_off_guide(at: Span, point: str, line: str, gap: str) -> Message:
    """A slider, or a pin in a slot, is not drawn on the line along which it slides.

    pivot O at (0 mm, 0 mm)
    slider B along x through O
    B at (90 mm, 10 mm)      # wrong: 10 mm off the line
    B at (90 mm, 0 mm)       # right

    Without ``through`` the guide passes through the point as drawn.
    """
    message = f"{point} is drawn {gap} off {line}, more than the digits written account for"
    return Message(at, message, "correct the place, or the line")


@coded("E323")
def driven_is_given(at: Span, vector: str, given: Span) -> Message:
    """A link is driven whose direction is given by something else.

    OA = 40 mm @ phi
    drive OA from 10 deg to 80 deg     # wrong: phi is its direction
    drive phi from 10 deg to 80 deg    # right
    """
    message = f"'drive {vector}' drives what a formula gives"
    return Message(
        at, message, "drive the parameter in that formula", (Related(given, "it is given here"),)
    )


@coded("E324")
def place_without_value(at: Span, point: str) -> Message:
    """The coordinates of a drawn point have no value, so nothing is drawn.

    param a: length
    A at (a, 0 mm)           # wrong
    param a = 40 mm          # right
    """
    return Message(at, f"the place of {point} has no value", "give every parameter in it a value")


@coded("E325")
def driven_between_bodies(at: Span, vector: str) -> Message:
    """A drive names two points that no link and no telescope joins.

    link OA
    link AB
    drive OB from 10 deg to 80 deg   # wrong: no link goes through O and B
    drive OA from 10 deg to 80 deg   # right
    """
    message = f"'drive {vector}' names no link and no telescope"
    return Message(at, message, "drive a link or a telescope by its points, or a parameter")


@coded("E326")
def drawn_outside_range(at: Span, name: str) -> Message:
    """A parameter without a value has the one of the drawing, and its range leaves that out.

    param phi: angle in 70 deg .. 90 deg
    OA = 40 mm @ phi
    A at (20 mm, 34.64 mm)     # phi is 60 deg there
    """
    message = f"the value of '{name}' in the drawing is outside its range"
    return Message(at, message, "widen the range, or correct the drawing")


@coded("E327")
def drawn_nowhere(at: Span, point: str, is_pivot: bool) -> Message:
    """Of a mechanism by coordinates, one point has none, and nothing else says where it is.

    pivot O at (0 mm, 0 mm)
    link OAB
    A at (20 mm, 35 mm)
    B at (60 mm, 35 mm)      # without this: wrong
    OB = 70 mm @ OA          # or like this
    """
    line = f"{'pivot ' if is_pivot else ''}{point} at (x, y)"
    return Message(at, f"nothing says where {point} is", f"add its place: `{line}`")


@coded("E345")
def fall_drawn_backwards(at: Span, tail: str, head: str) -> Message:
    """A fall of a rope is drawn one way, and its direction is the other.

    Along a rope each fall has the direction from its first point to its second::

        D at (0 m, 2 m)
        K at (0 m, 1 m)
        rope D, K along y, B along y     # wrong: from D to K it runs downwards
        rope D, K along -y, B along y    # right
    """
    message = f"the fall from {tail} to {head} is drawn against its direction"
    return Message(at, message, "turn the direction round, or correct the places")


@coded("W351")
def fall_drawn_across(at: Span, tail: str, head: str, apart: float) -> Message:
    """A fall of a rope is drawn across its direction.

    It touches pulleys and does not run through their axles, but that turns it by some degrees
    only where they are small against its length. The direction is what counts::

        D at (0 m, 2 m)
        K at (0.1 m, 1 m)
        rope D, K along x, B along y     # warned of: from D to K it is drawn downwards
        rope D, K along -y, B along y    # right
    """
    message = f"the fall from {tail} to {head} is drawn {math.degrees(apart):.3g} deg from"
    return Message(at, f"{message} its direction", "correct the direction, or the places")


@coded("W352")
def fall_off_its_drum(at: Span, end: str, point: str, off: float, radius: float) -> Message:
    """A fall of a rope or band, from the end where it is fast, does not touch the drum.

    The distance of its line from the drum's axle is the radius: the force in the fall has that
    arm, in friction and on the link at its other end::

        pivot O at (0 mm, 0 mm)
        C at (-300 mm, -100 mm)
        rope C, O along x, A along -y                        # passes O at 100 mm
        friction rope O 0.3 wrap 270 deg drum 400 mm on OG   # warned of
        friction rope O 0.3 wrap 270 deg drum 200 mm on OG   # right
    """
    sizes = (f"{size * 1000:.6g} mm" for size in (off, radius))
    message = "the fall from {0} passes {1} at {2}, and the drum has the radius {3}"
    hint = "correct the diameter, the direction of the fall, or the places"
    return Message(at, message.format(end, point, *sizes), hint)


@coded("W320")
def drawn_elsewhere(at: Span, point: str, place: str, gap: str) -> Message:
    """With the lengths and directions given, a point is not where it is drawn.

    What is given holds; the drawing only tells closures apart. A gap of more than the
    digits written account for means that one of the two is mistaken::

        OA = 40 mm @ phi         # at phi = 60 deg A is at (20 mm, 34.64 mm)
        A at (20 mm, 30 mm)      # warned of
    """
    message = f"{point} is drawn {gap} from where the rest puts it, which is {place}"
    return Message(at, message, "correct the place, or what is given besides")


@coded("W321")
def place_unused(at: Span, point: str, pivot: str) -> Message:
    """A point has a place, and nothing that has a place, too, is tied to it.

    Coordinates have a meaning relative to others: where vectors lead to a point from a pivot that
    has no place, its own says nothing, and is compared with nothing::

        pivot O
        OB = 50 mm @ phi
        B at (30 mm, 40 mm)      # warned of: (30 mm, 40 mm) from where?

    With `pivot O at (0 mm, 0 mm)` it is compared with the vector, or selects the closure.
    """
    message = f"the place of {point} has no effect: nothing that it is tied to has one"
    hint = f"give it one as well, as in `pivot {pivot} at (0 mm, 0 mm)`, or leave this line out"
    return Message(at, message, hint if pivot else "leave this line out")


@coded("W349")
def wrapped_backwards(at: Span, point: str, clockwise: bool) -> Message:
    """A rope goes around its drum the other way than its wrap says.

    The wrap is positive where the rope goes counter-clockwise, on its way from the first point
    that its line names. Which end is the tight one follows from its sign::

        A at (-100 mm, -300 mm)
        B at (100 mm, -300 mm)
        rope A, O along y, B along -y                        # over the drum on O, clockwise
        friction rope O 0.3 wrap 180 deg drum 200 mm on OC   # warned of
        friction rope O 0.3 wrap -180 deg drum 200 mm on OC  # right
    """
    drawn, said = ("counter-clockwise", "clockwise")[:: -1 if not clockwise else 1]
    message = f"the rope is drawn {drawn} around {point}, and its wrap is {said}"
    return Message(at, message, "turn the sign of the wrap round, or correct the places")


@coded("W350")
def wrapped_farther(at: Span, point: str, wrap: float, turn: float) -> Message:
    """A rope turns at a pulley by another angle, as its falls are drawn, than its wrap says.

    Forces run along the falls, from point to point where no direction is given, and friction
    follows the wrap. Some degrees are left to the size of pulleys::

        A at (0 mm, -300 mm)
        B at (400 mm, 0 mm)
        rope A, O, B                         # up, and to the right: a quarter of a turn
        friction rope O 0.2 wrap 180 deg     # warned of
        friction rope O 0.2 wrap 90 deg      # right
    """
    drawn, said = abs(math.degrees(math.remainder(turn, math.tau))), math.degrees(wrap)
    message = f"the rope is drawn to turn by {drawn:.4g} deg at {point}, its wrap is {said:.6g} deg"
    return Message(at, message, "correct the wrap, the places, or give the falls directions")


@coded("E516")
def wheels_alone_lead(at: Span, body: str, wheels: str) -> Message:
    """A link or a slider moves only through wheels, and how far they have turned is not known.

    Where the drive turns a wheel, what it leads follows from where it is drawn, along the
    whole stroke. Behind a loop of rods the turn of a wheel is no formula of the drive yet::

        drive OA from 30 deg to 80 deg       # OA, AB and QB are a four-bar linkage
        gear Q 20 mm, C 50 mm                # wrong: nothing says where CD is

    With a name for the direction that the loop gives, the link's own can be written::

        param psi: angle
        QB = @ psi
        CD = @ 30 deg - 20/50*(psi - 80 deg)
    """
    return Message(
        at,
        f"only {wheels} leads {body}, by a motion that is no formula of the drive",
        f"give the place of {body} by a formula of what leads it",
    )
