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
        return Message(span, message, "is its unit right, or has it digits too many or too few?")
    message = f"'{name}' is in {unit}, and far from the other lengths, which are in {others}"
    return Message(span, message, "is its unit right?")


@coded("W266")
def place_far_off(span: Span, point: str) -> Message:
    """A point is drawn a hundred times farther from all others than these are apart.

    A at (20 mm, 35 mm)
    B at (80 m, 60 mm)     # warned of
    B at (80 mm, 60 mm)    # right
    """
    message = f"{point} is drawn over a hundred times farther away than the other points are apart"
    return Message(span, message, "are the units of its coordinates right?")


@coded("W248")
def asked_twice(span: Span, name: str, other: str, first: Span) -> Message:
    """The same is asked for under two names.

    find k = P/F
    find j = P/F     # warned of: was another ratio meant?
    """
    related = (Related(first, f"'{other}' asks for it here"),)
    message = f"'{name}' asks for the same as '{other}'"
    return Message(span, message, "remove one, or change what was copied", related)


@coded("W288")
def both_given(span: Span, name: str, above: str, below: str, asked: Span) -> Message:
    """Both loads of a ratio have values, and the ratio says what one of them is.

    find k = P/F
    let F = 3 kN
    let P = 2 kN      # warned of: balance demands k*F
    let P = k*F       # right
    """
    related = (Related(asked, f"{name} is asked for here"),)
    message = f"'{above}' has a value, and follows from '{below}': {above} = {name}*{below}"
    hint = "leave one of the two out, or call what is there to bear it otherwise"
    return Message(span, message, hint, related)


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
def link_of_ground(span: Span, link: str, held: Sequence[str] = ()) -> Message:
    """Two pins of a link are pivots of the ground, so that it is a part of the ground.

    The ground needs no link: its pivots stand where they are said to::

        pivot O at (0 mm, 0 mm)
        pivot Q at (100 mm, 0 mm)
        link OQ                       # warned of
        link OQA                      # warned of, too: A stands still
    """
    message = f"all points of link {link} are pivots of the ground, so it cannot move"
    if held:
        message = f"{listed(held, 'and')} of link {link} are pivots, so it cannot move"
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
    """A load, a mass, the rate of a spring or the speed of a drive is zero: it has no influence.

    let F = 0 N              # warned of
    weight W mass 0 kg at G  # warned of

    Where a parameter with a range makes it zero, nothing is said.
    """
    return Message(
        span, f"{what} is zero, so it has no influence", "give its size, or leave it out"
    )


@coded("W286")
def strange_gravity(span: Span, value: float) -> Message:
    """The acceleration of free fall is far from that of any planet: its unit is wrong.

    param g = 9.81 mm/s^2     # warned of
    param g = 9810 mm/s^2     # right
    param g = 1.62 m/s^2      # right, on the Moon
    """
    message = f"'g', the acceleration of free fall where there are weights, is {value:.4g} m/s^2"
    return Message(span, message, "is its unit right? 9.81 m/s^2 is 9810 mm/s^2")


@coded("W278")
def weight_in_mass(span: Span, digits: str) -> Message:
    """A mass is multiplied by the acceleration of free fall, and ``weight`` does that again.

    weight W mass 100 kg * 9.81 at G     # warned of: a weight of 9620 N
    weight W mass 100 kg at G            # right: 981 N
    """
    message = f"a mass is multiplied by {digits}, and a weight is the mass times g already"
    return Message(span, message, f"leave out the {digits}: `weight` takes the mass")


@coded("W277")
def idle_telescope(span: Span, name: str) -> Message:
    """Nothing acts in a telescope, so that it bears no force and may as well be left out.

    A telescope is a cylinder or a spring strut: an actuator or a spring between its ends::

        telescope CA
        actuator P between C and B     # warned of: P acts beside the telescope
        actuator P between C and A     # right
    """
    message = f"no actuator and no spring acts between the ends of telescope {name}"
    hint = "it bears nothing so: let an actuator or a spring act between its ends, or leave it out"
    return Message(span, message, hint)


@coded("W280")
def tolerance_of_all(span: Span) -> Message:
    """The tolerance of an expected figure is as large as the figure, so that it tests little.

    expect k = 0.353 +- 1      # warned of: zero agrees, too
    expect k = 0.353 +- 1e-3   # right
    """
    message = "the tolerance is as large as the figure, so that zero agrees with it"
    return Message(span, message, "is a digit or a unit too many?")


@coded("W281")
def condition_of_one_value(span: Span, name: str) -> Message:
    """A condition of use holds at one value of a parameter: code gives NaN at any other.

    require alpha = 10 deg     # warned of
    param alpha = 10 deg       # right: its value
    param beta = 2*alpha       # right: what follows from another
    """
    message = f"this condition holds at one value of {name}, and at any other code gives NaN"
    return Message(span, message, f"a value is given where it is declared: `param {name} = …`")


@coded("W282")
def condition_of_constants(span: Span) -> Message:
    """A condition names nothing that could vary: it holds always, or never.

    require 1 < 2                        # warned of
    let c = 0.3 when 5 mm < 6 mm else 1  # warned of
    require a < 2 mm                     # right
    """
    hint = "name what the condition is about, as in `a < 2 mm`"
    return Message(span, "this condition compares constants, so that it states nothing", hint)


@coded("W285")
def setting_outside_range(span: Span, name: str, declared: Span) -> Message:
    """An expected figure is for a value of a parameter outside its range.

    param alpha = 10 deg in 2 deg .. 40 deg
    expect k = 11.3 at alpha = 80 deg           # warned of
    """
    related = (Related(declared, f"the range of {name}"),)
    message = f"'{name}' is set outside its range"
    return Message(span, message, "correct the value, or widen the range", related)


@coded("W279")
def area_for_square(span: Span, digits: str, unit: str, power: str) -> Message:
    """A number in square units stands where that of a length is squared, behind pi.

    The power belongs to the unit: 50 mm^2 are fifty square millimetres::

        let A = pi*50 mm^2/4       # warned of: 39 mm^2
        let A = pi*(50 mm)^2/4     # right: 1963 mm^2
    """
    kind = {"2": "square", "3": "cubic", "4": "fourth"}[power]
    message = f"{digits} {unit}^{power} is a number of {kind} units, not a power of {digits} {unit}"
    return Message(span, message, f"write ({digits} {unit})^{power}")


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
