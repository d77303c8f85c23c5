"""Messages for quantities: dimensions, bare numbers, ranges, values (E220 to E230)."""

from collections.abc import Iterable, Mapping

from ...source import Span
from ...units import (
    ACCELERATION,
    ANGLE,
    FORCE,
    FREQUENCY,
    LENGTH,
    MASS,
    NUMBER,
    PRESSURE,
    STIFFNESS,
    TORQUE,
    USUAL_UNITS,
    Dimension,
    base_units,
    described,
)
from ..diagnostic import Message, Related, coded, near_miss, used_at


@coded("E220")
def mixed_dimensions(
    span: Span,
    dimension: Dimension,
    first: Span,
    first_dimension: Dimension,
    act: str,
    declared: Iterable[tuple[str, Span]] = (),
) -> Message:
    """Quantities of different dimensions are added or compared.

    Every formula has one dimension. An angle is a dimension of its own in sums and
    comparisons, and a pure number in products.

        param a     = 40 mm
        param alpha = 30 deg
        OB = a + alpha @ 0      # wrong: a length and an angle
        OB = a @ alpha          # right
    """
    message = f"cannot {act} {described(first_dimension)} and {described(dimension)}"
    related = [Related(first, f"this is {described(first_dimension)}")]
    related += [Related(place, f"'{name}' is declared here") for name, place in declared]
    return Message(span, message, lost_factor(first_dimension, dimension), tuple(related))


LOST = "look for a wrong unit, a wrong name, or a lost factor"


def lost_factor(one: Dimension, other: Dimension) -> str:
    """Return the hint for two dimensions that should be one, which names a simple factor.

    >>> lost_factor(FORCE, FORCE.joined(Dimension(2)))
    'they differ by a factor in m^2: look for a number without its unit, or a lost factor'
    """
    factor = one.over(other)
    forwards = next((e > 0 for e in factor if e), True)
    factor = factor if forwards else factor.scaled(-1)
    is_simple = factor == ACCELERATION or sum(map(bool, factor)) == 1
    if not is_simple or one.angle or other.angle:
        return LOST
    said = base_units(factor)
    return (
        f"they differ by a factor in {said}: look for a number without its unit, or a lost factor"
    )


EXCHANGED = "the length stands before '@', the direction behind it; else look for a wrong unit"

MEANT_FOR: Mapping[tuple[Dimension, str], str] = {
    (ANGLE, "the length"): EXCHANGED,
    (LENGTH, "the direction"): EXCHANGED,
    (LENGTH, "a direction"): "a direction is an angle, x, -x, y, -y, or that of a vector, AB",
    (LENGTH, "a coefficient of friction"): (
        "the coefficient stands before the size: friction pins 0.1 diameter 10 mm"
    ),
    (TORQUE, "the rate of a spring"): (
        "a spring that turns a link is a torque of its angle: torque M on OA, "
        "let M = -c*(phi_OA - 20 deg)"
    ),
    (PRESSURE, "an intensity"): "a pressure times the width on which it acts: 0.2 MPa*50 mm",
    (FORCE, "an intensity"): (
        "an intensity is a force on a length, 100 N/m; a load at one point is a force"
    ),
    (ANGLE, "the place"): "a place is two lengths; a length and a direction are written a @ alpha",
    (ANGLE, "a coefficient of friction"): (
        "the coefficient for an angle of friction is its tangent: tan(6 deg)"
    ),
    (ACCELERATION, "a direction"): (
        "gravity has a direction, -y; its size is a parameter: g = 9.81 m/s^2"
    ),
}
"""Hints by what is there, and what it is there for."""

MEANT: Mapping[tuple[Dimension, Dimension], str] = {
    (PRESSURE, FORCE): "the force of a cylinder is its pressure on the piston: let P = p*pi*D^2/4",
    (FORCE, MASS): "a weight that is given as a force is one: `force W at G along -y`",
    (MASS, FORCE): "a mass acts as a load by `weight W mass … at G`; a force is in N or lbf",
}
"""Hints by what is there, and what is wanted."""


def _meant_by(found: Dimension, wanted: Dimension, what: str) -> str:
    """Return the hint at a usual mistake for another quantity, '' where it is none."""
    unit = USUAL_UNITS.get(wanted, "")
    if found == NUMBER.over(LENGTH) and wanted == LENGTH:
        return f"1/2 {unit} is 1/(2 {unit}): a fraction is a number with a point, 0.5 {unit}"
    if what == "an exponent":
        return "a unit belongs to the number before it: 2*10^2 mm is 2e2 mm, or 200 mm"
    if (found, wanted) == (FORCE, MASS) and what.startswith("the range"):
        return "kg measures a mass; the force of a mass is given in kgf, or in N"
    return MEANT_FOR.get((found, what)) or MEANT.get((found, wanted), "")


@coded("E221")
def wrong_dimension(
    span: Span,
    found: Dimension,
    wanted: Dimension,
    what: str,
    name: str = "",
    declared: Span | None = None,
) -> Message:
    """A quantity of another dimension stands where a length, an angle, a force … is wanted.

    OB = alpha @ a      # wrong: length and direction are exchanged
    OB = a @ alpha      # right
    """
    of_a_length = (what, wanted) == ("an intensity", STIFFNESS)
    expected = "a force on a length (N/mm)" if of_a_length else described(wanted)
    said = f"{what}: expected {expected}, found {described(found)}"
    unit = USUAL_UNITS.get(wanted, "")
    bare = name and unit and found == NUMBER
    plain = f"if '{name}' is a number without its unit, declare it as `… {unit}`" if bare else LOST
    hint = _meant_by(found, wanted, what) or plain
    if declared and wanted in (LENGTH, ANGLE) and found not in (LENGTH, ANGLE, NUMBER):
        return Message(declared, said, hint, (Related(span, f"'{name}' is {what} here"),))
    related = (
        (Related(declared, f"'{name}' is declared here"),) if declared and declared != span else ()
    )
    return Message(span, said, hint, related)


A_TURN = 6.3
"""In radians: fractions of less are as likely radians as degrees."""


@coded("E222")
def bare_number(span: Span, digits: str, wanted: Dimension, use: Span | None = None) -> Message:
    """A number without a unit stands where a quantity is wanted.

    Thirty what? Millimetres and metres, degrees and radians would all be possible, so
    the unit is written. Only 0 needs none.

        OB = 40 @ 30              # wrong
        OB = 40 mm @ 30 deg       # right
    """
    unit = USUAL_UNITS.get(wanted, "")
    hint = f"write {digits} {unit}" if unit else "write its unit"
    if wanted == FREQUENCY:
        hint = f"write {digits} rpm, or {digits} {unit}"
    if wanted == ANGLE and digits.startswith("9.8"):
        hint = f"write {digits} deg; gravity is a direction, its size a parameter: g = 9.81 m/s^2"
    elif wanted == ANGLE and "." in digits and abs(float(digits)) < A_TURN:
        hint = f"write {digits} rad, or {digits} {unit}"
    related = used_at(use, span) if use else ()
    return Message(span, f"{digits} what? Expected {described(wanted)}", hint, related)


@coded("E223")
def exponent_not_number(span: Span, base: Dimension) -> Message:
    """A quantity with a dimension is raised to a power that is no constant number.

    The dimension of ``a^n`` is known only where ``n`` is written as a number; a pure
    number may be raised to anything.

        let v = a^n         # wrong where a is a length
        let v = (a/b)^n     # right
    """
    message = f"the exponent of {described(base)} is a constant number, found a formula"
    return Message(span, message, "divide by a quantity of its kind first: (a/b)^n")


@coded("E224")
def number_too_large(span: Span) -> Message:
    """A constant is too large or an exponent beyond 64: nothing measured is like that.

    Numbers are kept exactly, and powers of powers would fill the memory.

        param n = 9^9^9^9     # wrong
    """
    return Message(span, "this number is too large to compute with", "exponents go up to 64")


@coded("E225")
def divided_by_zero(span: Span) -> Message:
    """A formula divides by a constant that is zero.

    param n = 1/(2 - 2)     # wrong
    """
    return Message(span, "this divisor is 0", "look for what was meant, or leave the term out")


@coded("E226")
def no_value(span: Span) -> Message:
    """A formula has no real value for the given parameters.

    param s = 2
    param beta = asin(s)         # wrong: no angle has the sine 2
    param beta = asin(s/4)       # right
    """
    message = "this formula has no real value at the given parameters"
    return Message(span, message, "is the argument of a root or an arc function out of its domain?")


@coded("E227")
def unknown_dimension(span: Span, name: str, known: Iterable[str]) -> Message:
    """A parameter is declared with a dimension that does not exist.

    param a: lenght     # wrong
    param a: length     # right
    """
    known = list(known)
    hint = near_miss(name, known) or f"dimensions: {', '.join(known)}"
    return Message(span, f"'{name}' is no dimension", hint)


@coded("E228")
def range_backwards(span: Span, name: str, is_empty: bool = False) -> Message:
    """The ends of a range are equal or exchanged.

    param a = 12 deg in 40 deg .. 2 deg     # wrong
    param a = 12 deg in 2 deg .. 40 deg     # right
    """
    if is_empty:
        message = f"the range of '{name}' is empty: its ends are the same"
        return Message(span, message, "leave the range out of what does not vary")
    return Message(span, f"the range of '{name}' does not go from low to high", "exchange its ends")


@coded("E229")
def range_of_dependent(span: Span, name: str) -> Message:
    """A parameter that depends on others has a range of its own.

    Its range follows from theirs. A condition that it must keep is a ``require``.

        param b = 2*a in 1 mm .. 2 mm     # wrong
        param b = 2*a                     # right
        require 1 mm < b < 2 mm
    """
    message = f"'{name}' follows from other parameters, so its range does too"
    return Message(span, message, "write a 'require' for a condition")


@coded("E230")
def not_constant(span: Span, name: str, what: str) -> Message:
    """A name stands where a constant is expected.

    Ends of ranges, ``times``, the number of ``copies`` and the values behind ``at`` are
    constants.

        param a = 2 mm in 1 mm .. b        # wrong
        param a = 2 mm in 1 mm .. 5 mm     # right
    """
    message = f"{what} is a constant, found the name '{name}'"
    return Message(span, message, f"write the value of {name} as a number")


@coded("E231")
def out_of_reach(span: Span, dimension: Dimension) -> Message:
    """A quantity is larger, or smaller, than anything that a mechanism has.

    Results are computed with some sixteen digits. Sums with such quantities lose all of
    them, and of an angle of very many turns even the sine has none left.

        param a = 1e300 mm     # wrong
        param t = 1e9 deg      # wrong
    """
    if dimension == ANGLE:
        message = "this angle is out of reach, expected at most 1000000 deg"
        return Message(span, message, "leave out whole turns of 360 deg")
    hint = "is the exponent mistyped?"
    if dimension == LENGTH:
        return Message(span, "this length is out of reach, expected 0.001 mm to 1000 km", hint)
    return Message(span, "this quantity is out of reach, expected 1e-60 to 1e60 in SI units", hint)


@coded("W220")
def value_outside_range(span: Span, name: str, edge: Span) -> Message:
    """The value of a parameter lies outside its own range.

    The value makes the pose that is drawn, the range is what is swept: one of the two
    is probably mistyped.

        param a = 50 deg in 2 deg .. 40 deg     # warned of
    """
    related = (Related(edge, "the range"),)
    hint = "correct the one that is mistyped"
    return Message(span, f"the value of '{name}' lies outside its range", hint, related)


@coded("W221")
def condition_broken(span: Span, compared: str) -> Message:
    """A ``require`` does not hold for the given values.

    The description is compiled, but at its own default pose the results do not apply.

        param alpha = 100 deg
        require alpha < 90 deg     # warned of

    The range of a part's parameter whose value a loop gives is such a condition, too.
    """
    message = f"the given values break this condition: {compared}"
    return Message(span, message, "give values that meet it, or change the condition")


@coded("E232")
def tolerance_not_positive(span: Span, what: str) -> Message:
    """A tolerance is zero or negative.

    It says how far a value may be off, to either side; an exact value has none.

        param a = 40 mm +- -0.1 mm       # wrong
        param a = 40 mm +- 0.1 mm        # right
    """
    return Message(span, f"the tolerance {what} is not positive", "write how far it may be off")


@coded("E233")
def tolerance_of_dependent(span: Span, name: str) -> Message:
    """A parameter that depends on others has a tolerance of its own.

    Its tolerance follows from theirs.

        param b = 2*a +- 0.1 mm          # wrong
        param a = 20 mm +- 0.05 mm       # right
        param b = 2*a
    """
    message = f"'{name}' follows from other parameters, so its tolerance does too"
    return Message(span, message, "give a tolerance to what it follows from")


@coded("E235")
def negative_quantity(span: Span, what: str, found: str, cause: Span) -> Message:
    """A mass, an intensity, the rate or the free length of a spring is negative.

    Nothing has a negative mass, and no spring pushes the harder the less it is pressed. The
    way a load acts is its direction: gravity, the arrow of a force.

        weight W mass -2 kg at G                     # wrong
        weight W mass 2 kg at G                      # right
        spring -5 N/mm between A and B free 80 mm    # wrong
    """
    text = f"{what} is negative: {found}"
    return Message(cause, text, "leave out its minus sign", used_at(span, cause))


@coded("W297")
def range_in_two_units(span: Span, what: str, first: str, second: str) -> Message:
    """The ends of a range or of a stroke are in two units, of which one is a slip as a rule.

    param l = 200 mm in 100 mm .. 300 m       # warned of
    param l = 200 mm in 100 mm .. 300 mm      # right
    """
    return Message(span, f"{what} is in two units, {first} and {second}", "write both in one unit")


@coded("W295")
def coordinates_in_two_units(span: Span, first: str, second: str) -> Message:
    """The coordinates of one place are in two units, of which one is a slip as a rule.

    A at (12 cm, 60 mm)      # warned of
    A at (120 mm, 60 mm)     # right
    """
    message = f"the coordinates of one place are in two units, {first} and {second}"
    return Message(span, message, "write both in one unit")
