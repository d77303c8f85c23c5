"""Messages for sizes that can be meant, and hardly ever are (W2xx)."""

from collections.abc import Sequence
from typing import Literal

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


@coded("W275")
def friction_far_off(span: Span, what: str) -> Message:
    """Friction is so large that a length in its line hardly has the right unit.

    The friction circle of a pin, of radius f·d/2, is larger than every length of the mechanism;
    or a guide resists with over ten times its normal force, as its pin is so far from its middle.

        friction pins 0.1 diameter 10 m                          # warned of
        friction pins 0.1 diameter 10 mm                         # right
        friction slider K 0.1 guide 80 mm overhang 60 m          # warned of
    """
    return Message(span, what, "are the units of its lengths right?")


@coded("W298")
def spring_far_off(span: Span, points: str, times: float) -> Message:
    """A spring is drawn more than ten times as long, or as short, as it is without force.

    No spring bears that, so that one of the units is wrong::

        spring 5 N/mm between D and A free 180 m     # warned of where D and A are 220 mm apart
        spring 5 N/mm between D and A free 180 mm    # right
    """
    than = f"{times:.4g} times" if times > 1 else f"1/{1 / times:.4g} of"
    message = f"the free length of the spring is {than} the drawn distance {points}"
    return Message(span, message, "is its unit right?")


@coded("W251")
def coefficient_above_one(span: Span, what: str, value: float) -> Message:
    """A coefficient of friction is above 1, which dry surfaces hardly ever reach.

    Per cent written as whole numbers, and angles of friction, are the usual cause.

        friction slider K 15        # warned of
        friction slider K 0.15      # right
    """
    message = f"{what} is {value:.6g}, expected at most 1"
    return Message(span, message, "is it in per cent? A hundredth is written 0.01")


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


ToleranceDoubt = Literal["value", "range", "angle"]
"""What a tolerance is large relative to: the value, the range, or any angle that is off."""

_TOLERANCES: dict[ToleranceDoubt, str] = {
    "value": "as large as its value: it may come to zero",
    "range": "wider than its range",
    "angle": "ten degrees or more, expected less",
}


@coded("W280")
def tolerance_of_all(span: Span, parameter: str = "", of: ToleranceDoubt = "value") -> Message:
    """A tolerance is as large as what it is of: of an expected figure it tests little.

    Of an angle it is ten degrees or more, of what has a range it is wider than that.

    param a = 40 mm +- 60 mm   # warned of
    param alpha = 10 deg +- 50 deg            # warned of: it runs over a range
    param alpha = 10 deg in 2 deg .. 60 deg   # right
    expect k = 0.353 +- 1      # warned of: zero agrees, too
    expect k = 0.353 +- 1e-3   # right
    """
    message = "the tolerance is as large as the figure, so that zero agrees with it"
    if parameter:
        message = f"the tolerance of '{parameter}' is {_TOLERANCES[of]}"
    if of == "angle":
        return Message(span, message, "an angle that is adjusted has a range: `in … deg .. … deg`")
    return Message(span, message, "is a digit or a unit too many?")


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


@coded("W211")
def factor_between_units(span: Span, digits: str, speed: str, unit: str) -> Message:
    """A number stands in a formula that only changes the units of a speed, a torque and a power.

    Books have P = M·n/9550 for kW, N·m and revolutions per minute. Here a quantity brings its unit
    with it, and a speed counts radians, so that such a number is one factor too many::

        param n = 1500 rpm
        let P = M*n/9550       # warned of
        let P = M*n in kW      # right
    """
    message = f"{digits} stands for units, and '{speed}' has its unit itself"
    return Message(span, message, f"leave the number out, and ask for a unit: … in {unit}")
