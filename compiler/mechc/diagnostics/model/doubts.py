"""Messages for what can be meant, and hardly ever is (W245 to W257)."""

from collections.abc import Sequence

from ...source import Span
from ..diagnostic import Message, Related, coded
from ..syntax import listed


@coded("W245")
def beyond_a_turn(span: Span, what: str, turns: float) -> Message:
    """An angle is more than a full turn, and nothing in the mechanism counts turns.

    Radians written for degrees are the usual cause. Where gears, belts, racks or screws
    turn on, nothing is said.

        param alpha = 10 rad                 # warned of: 573 deg
        param alpha = 10 deg                 # right
        drive phi from 0 deg to 4000 deg     # warned of: all repeats after 360 deg
    """
    message = f"{what} is {turns:.3g} turns, expected at most one"
    return Message(span, message, "is it meant in degrees? Leave out full turns")


@coded("W246")
def length_vanishes(span: Span, points: str, length: str, name: str, where: str) -> Message:
    """A length comes to zero, below it or to infinity within what a parameter may be.

    The range, the tolerance or the stroke reaches to where the vector has no length, or
    points the other way round. What a used sheet gives may have no value there: a list has no
    size so large, a table no such row.

        param s = 500 mm in -400 mm .. 900 mm      # warned of, with AB = s
        param s = 500 mm in 400 mm .. 900 mm       # right
        param l = 20 mm +- 30 mm                   # warned of, with AB = l
    """
    if not length:
        message = f"{where} of {name} leaves the length of {points} without a value"
        return Message(span, message, "keep it to where lists, tables and choices give one")
    message = f"{where} of {name} takes the length of {points} to {length}"
    return Message(span, message, "keep it to where the length is positive")


@coded("W247")
def length_far_off(span: Span, name: str, unit: str, others: str) -> Message:
    """A length is more than a hundred times the others, or less than a hundredth of them.

    Where all lengths are in one unit it takes two others at least.

        param a = 40 mm
        param b = 120 m      # warned of
        param b = 120 mm     # right
    """
    if not others:
        message = f"'{name}' is over a hundred times larger or smaller than every other length"
        return Message(span, message, "has it digits too many or too few?")
    message = f"'{name}' is in {unit}, and far from the other lengths, which are in {others}"
    return Message(span, message, "is its unit right?")


@coded("W248")
def asked_twice(span: Span, name: str, other: str, first: Span) -> Message:
    """The same is asked for under two names.

    find k = P/F
    find j = P/F     # warned of: was another ratio meant?
    """
    related = (Related(first, f"'{other}' asks for it here"),)
    message = f"'{name}' asks for the same as '{other}'"
    return Message(span, message, "remove one, or change what was copied", related)


@coded("W249")
def drive_moves_nothing(span: Span, name: str) -> Message:
    """The driving coordinate stands in no vector, angle or guide: nothing moves with it.

    param phi = 60 deg
    drive phi from 10 deg to 80 deg
    OA = a @ 60 deg     # warned of
    OA = a @ phi        # right
    """
    message = f"no vector, angle or guide depends on {name}, so nothing moves with it"
    return Message(span, message, "drive what moves, or write it into the geometry")


@coded("W250")
def drive_reshapes(span: Span, name: str, tail: str, head: str, body: str) -> Message:
    """The driving coordinate is a size of a rigid body, or a distance of pivots.

    Nothing in the mechanism changes it, so the rows of a stroke belong to as many different
    mechanisms. That is a study of sizes; speeds along it mean nothing.

        OA = r @ phi
        drive r from 20 mm to 60 mm      # warned of: OA is a link
        drive phi from 0 deg to 360 deg  # right
    """
    what = f"the length of {tail}{head}" if tail else f"the place of {head}"
    message = f"{name} is no motion: it changes {what}, and {body} is rigid"
    return Message(span, message, "drive an angle of a link, or the length of what is variable")


@coded("W251")
def coefficient_above_one(span: Span, what: str, value: float) -> Message:
    """A coefficient of friction is above 1, which dry surfaces hardly ever reach.

    Per cent written as whole numbers, and angles of friction, are the usual cause.

        friction slider K 15        # warned of
        friction slider K 0.15      # right
    """
    message = f"{what} is {value:.6g}, expected at most 1"
    return Message(span, message, "is it in per cent? A hundredth is written 0.01")


@coded("W252")
def pivots_coincide(span: Span, point: str, other: str, first: Span) -> Message:
    """Two pivots are at one place, so that what turns on them turns on one axis.

    A linkage between such pivots turns as one rigid body. Wheels may sit on one axis.

        pivot O at (0 mm, 0 mm)
        pivot Q at (0 mm, 0 mm)     # warned of
        pivot Q at (d, 0 mm)        # right
    """
    related = (Related(first, f"the place of {other}"),)
    message = f"pivot {point} is at the same place as pivot {other}"
    return Message(span, message, "correct the place, or use one pivot for both", related)


@coded("W253")
def link_within_link(span: Span, link: str, other: str, first: Span) -> Message:
    """All pins of a link are pins of another one, with which it moves as one body.

    It demands nothing of the motion, and the force it carries is not determined.

        link ABE
        link AE      # warned of
    """
    related = (Related(first, f"link {other}"),)
    message = f"all points of link {link} are on link {other}, so the two move as one"
    return Message(span, message, "leave it out, or correct its points", related)


@coded("W262")
def link_of_ground(span: Span, link: str) -> Message:
    """All pins of a link are pivots of the ground, so that it is a part of the ground.

    The ground needs no link: its pivots stand where they are said to::

        pivot O at (0 mm, 0 mm)
        pivot Q at (100 mm, 0 mm)
        link OQ                       # warned of
    """
    message = f"all points of link {link} are pivots of the ground, so it cannot move"
    return Message(span, message, "leave it out, or correct its points")


@coded("W264")
def guide_along_link(span: Span, point: str, link: str) -> Message:
    """The direction of a guide is that of a link that moves; a guide is fast in the ground.

    It is as if the guide were turned with the link, for every pose anew::

        slider B along OA        # warned of, where OA moves
        slot B in OA             # right, where B slides along OA
        slider B along 30 deg    # right, where the ground guides it
    """
    message = f"the guide of {point} is fast in the ground, and its direction that of link {link}"
    hint = f"a point that slides along a link is written slot {point} in …; a guide has an angle"
    return Message(span, message, hint)


@coded("W254")
def telescope_between_fixed(span: Span, name: str, body: str) -> Message:
    """The ends of a telescope keep their distance, so it can neither extend nor push.

    link OB
    telescope OB     # warned of: link OB holds both ends
    telescope CB     # right
    """
    message = f"{body} holds both ends of telescope {name}, so its length never changes"
    return Message(span, message, "name the points that move apart")


@coded("W255")
def of_no_size(span: Span, what: str) -> Message:
    """A load, a mass or the rate of a spring is zero: it has no influence.

    let F = 0 N              # warned of
    weight W mass 0 kg at G  # warned of

    Where a parameter with a range makes it zero, nothing is said.
    """
    return Message(
        span, f"{what} is zero, so it has no influence", "give its size, or leave it out"
    )


@coded("W256")
def let_without_value(span: Span, name: str) -> Message:
    """A user-defined formula has no finite value at the given parameters.

    It divides by zero there, or asks for a root or an arc function of what has none.

        param l = 200 mm
        let z = 1/(l - 200 mm)     # warned of
    """
    message = f"'{name}' has no finite value at the given parameters"
    return Message(span, message, "check signs and brackets, or the values")


@coded("W257")
def pins_overlap(span: Span, diameter: float, points: Sequence[str], apart: float) -> Message:
    """Pins of one diameter stand closer on a link than they are thick, so that they overlap.

    A radius, or another unit, is the usual cause. Eccentrics, which are pins that enclose
    others, are given one by one: ``friction pin A f diameter d``.

        OB = 20 mm @ alpha
        friction pins 0.1 diameter 200 mm     # warned of
        friction pins 0.1 diameter 8 mm       # right
    """
    message = (
        f"pins of {diameter * 1000:.6g} mm overlap: "
        f"{listed(points, 'and')} are {apart * 1000:.6g} mm apart"
    )
    return Message(span, message, "check the diameter")


@coded("W206")
def keeps_its_arrow(span: Span, name: str, pressing: str) -> Message:
    """A force that is a share of another one, and across it, seems to be friction.

    Friction turns round with the motion, and a load does not: ``k_f`` and ``k_hold`` are both
    found with this force as its arrow has it, which is right for one of them at most. What
    loses by it does not enter the efficiency either::

        force N at A along -y
        force T = mu*N at A along x     # warned of beside friction elsewhere
        friction pins 0.1 diameter 10 mm

    Describe the other sense by itself, with ``motion releasing`` and this arrow turned.
    """
    return Message(
        span,
        f"{name} keeps its arrow where the motion turns round: as friction under {pressing} it is "
        "right in one sense of the motion only",
        "for the other sense turn its arrow, in a description of its own",
    )
