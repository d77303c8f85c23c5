"""Units and dimensions: one table, exact factors.

Inside, everything is SI and radians; outside, the units the user wrote. The factor of
an angle unit in degrees is a rational multiple of π, so :class:`Unit` keeps it apart:
``deg`` has factor 1/180 and ``pi`` True.
"""

from difflib import get_close_matches
from fractions import Fraction
from typing import NamedTuple


class Dimension(NamedTuple):
    """Exponents of length, mass, time and angle.

    Angle is a dimension in sums, comparisons and function arguments; in products it is
    a pure number, so a product never carries an angle exponent other than 0 or 1.

    >>> FORCE
    Dimension(length=1, mass=1, time=-2, angle=0)
    """

    length: int | Fraction = 0
    mass: int | Fraction = 0
    time: int | Fraction = 0
    angle: int = 0

    def scaled(self, exponent: int | Fraction) -> "Dimension":
        """Return the dimension of a power; an angle's is that of a pure number.

        >>> LENGTH.scaled(2)
        Dimension(length=2, mass=0, time=0, angle=0)
        """
        return Dimension(self.length * exponent, self.mass * exponent, self.time * exponent)

    def joined(self, other: "Dimension") -> "Dimension":
        """Return the dimension of a product, where angles are pure numbers.

        >>> FORCE.joined(LENGTH) == TORQUE
        True
        """
        return Dimension(self.length + other.length, self.mass + other.mass, self.time + other.time)

    def over(self, other: "Dimension") -> "Dimension":
        """Return the dimension of a quotient, where angles are pure numbers.

        >>> TORQUE.over(FORCE) == LENGTH
        True
        """
        return self.joined(other.scaled(-1))


NUMBER = Dimension()
ANGLE = Dimension(angle=1)
LENGTH = Dimension(1)
MASS = Dimension(0, 1)
TIME = Dimension(0, 0, 1)
FORCE = Dimension(1, 1, -2)
TORQUE = Dimension(2, 1, -2)
PRESSURE = Dimension(-1, 1, -2)
VELOCITY = Dimension(1, 0, -1)
ACCELERATION = Dimension(1, 0, -2)
STIFFNESS = Dimension(0, 1, -2)
POWER = Dimension(2, 1, -3)
FREQUENCY = Dimension(0, 0, -1)

DIMENSIONS: dict[str, Dimension] = {
    "number": NUMBER,
    "angle": ANGLE,
    "length": LENGTH,
    "area": Dimension(2),
    "volume": Dimension(3),
    "mass": MASS,
    "time": TIME,
    "force": FORCE,
    "torque": TORQUE,
    "pressure": PRESSURE,
    "velocity": VELOCITY,
    "acceleration": ACCELERATION,
    "stiffness": STIFFNESS,
    "power": POWER,
    "frequency": FREQUENCY,
}
"""The dimensions that a parameter may be declared with, by name."""


SPELLED: dict[str, str] = {
    "millimeter": "mm", "millimetre": "mm", "centimeter": "cm", "centimetre": "cm",
    "meter": "m", "metre": "m", "micrometer": "um", "micron": "um", "degree": "deg", "°": "deg",
    "radian": "rad", "newton": "N", "kilonewton": "kN", "kilogram": "kg", "gram": "g",
    "tonne": "t", "pascal": "Pa", "second": "s", "minute": "min", "watt": "W", "joule": "J",
    "hertz": "Hz", "nm": "N*m", "nmm": "N*mm", "ncm": "N*cm", "knm": "kN*m", "kgfm": "kgf*m",
    "revolution": "rev", "turn": "rev", "mps": "m/s",
}  # fmt: skip
"""What people write for a unit, in small letters and the singular."""


def unit_meant(word: str) -> str:
    """Return the unit that a word behind a number most likely means, '' where none is near.

    >>> unit_meant("degrees"), unit_meant("MM"), unit_meant("Nm"), unit_meant("milimeter")
    ('deg', 'mm', 'N*m', 'mm')
    """
    small = word.lower()
    known = {unit.lower(): unit for unit in UNITS if unit.isalpha()} | SPELLED
    for spelled in (small, small.removesuffix("s")):
        if spelled in known:
            return known[spelled]
    near = get_close_matches(small.removesuffix("s"), SPELLED, n=1, cutoff=0.85)
    return SPELLED[near[0]] if near and len(small) > 3 else ""


FOREIGN = {
    "in": ("inches", 25.4, "mm"),
    "inch": ("inches", 25.4, "mm"),
    "inches": ("inches", 25.4, "mm"),
    "ft": ("feet", 304.8, "mm"),
    "foot": ("feet", 304.8, "mm"),
    "feet": ("feet", 304.8, "mm"),
    "yd": ("yards", 914.4, "mm"),
    "lb": ("pounds", 0.45359237, "kg"),
    "lbs": ("pounds", 0.45359237, "kg"),
    "lbf": ("pounds of force", 4.4482216152605, "N"),
    "psi": ("pounds per square inch", 6894.757293168, "Pa"),
}
"""Units that are not read, and what one of each is in a unit that is."""


def foreign(digits: str, unit: str) -> str:
    """Return a hint for a number with a unit of another system, '' for any other.

    >>> foreign("8", "in")
    'inches are not read: 8 in are 203.2 mm'
    """
    if unit in UNITS or unit not in FOREIGN:
        return ""
    name, size, ours = FOREIGN[unit]
    return f"{name} are not read: {digits} {unit} are {float(digits) * size:.7g} {ours}"


USUAL_UNITS: dict[Dimension, str] = {
    ANGLE: "deg",
    LENGTH: "mm",
    DIMENSIONS["area"]: "mm^2",
    DIMENSIONS["volume"]: "mm^3",
    MASS: "kg",
    TIME: "s",
    FORCE: "N",
    TORQUE: "N*m",
    PRESSURE: "MPa",
    VELOCITY: "m/s",
    ACCELERATION: "m/s^2",
    STIFFNESS: "N/mm",
    POWER: "W",
    FREQUENCY: "rad/s",
}
"""A unit that people use for each named dimension, for messages."""


def described(dimension: Dimension) -> str:
    """Return the dimension in words for a message.

    >>> described(LENGTH), described(ANGLE), described(NUMBER)
    ('a length (mm)', 'an angle (deg)', 'a pure number')
    >>> described(Dimension(-1))
    'a quantity in 1/m'
    """
    if dimension == NUMBER:
        return "a pure number"
    for name, known in DIMENSIONS.items():
        if known == dimension:
            return f"{'an' if name[0] in 'aeiou' else 'a'} {name} ({USUAL_UNITS[known]})"
    return f"a quantity in {base_units(dimension)}"


def base_units(dimension: Dimension) -> str:
    """Return a dimension in SI base units.

    >>> base_units(FORCE)
    'kg*m/s^2'
    """
    powers = (("kg", dimension.mass), ("m", dimension.length), ("s", dimension.time))
    above = [_raised(unit, e) for unit, e in powers if e > 0]
    below = [_raised(unit, -e) for unit, e in powers if e < 0]
    return "/".join(["*".join(above) or "1", *below])


def _raised(unit: str, exponent: int | Fraction) -> str:
    if exponent == 1:
        return unit
    return f"{unit}^{exponent}" if Fraction(exponent).denominator == 1 else f"{unit}^({exponent})"


class Unit(NamedTuple):
    """A unit: its factor to SI, exact, times π when ``pi``, and its dimension."""

    factor: Fraction
    dimension: Dimension
    pi: bool = False


def _unit(factor: str | int, dimension: Dimension, pi: bool = False) -> Unit:
    return Unit(Fraction(factor), dimension, pi)


UNITS: dict[str, Unit] = {
    "mm": _unit("1/1000", LENGTH),
    "cm": _unit("1/100", LENGTH),
    "dm": _unit("1/10", LENGTH),
    "m": _unit(1, LENGTH),
    "km": _unit(1000, LENGTH),
    "um": _unit("1/1000000", LENGTH),
    "deg": _unit("1/180", ANGLE, pi=True),
    "rad": _unit(1, ANGLE),
    "mrad": _unit("1/1000", ANGLE),
    "rev": _unit(2, ANGLE, pi=True),
    "mm^2": _unit("1/1000000", Dimension(2)),
    "cm^2": _unit("1/10000", Dimension(2)),
    "m^2": _unit(1, Dimension(2)),
    "mm^3": _unit("1/1000000000", Dimension(3)),
    "cm^3": _unit("1/1000000", Dimension(3)),
    "m^3": _unit(1, Dimension(3)),
    "N": _unit(1, FORCE),
    "daN": _unit(10, FORCE),
    "kN": _unit(1000, FORCE),
    "MN": _unit(1000000, FORCE),
    "kgf": _unit("9.80665", FORCE),
    "N*m": _unit(1, TORQUE),
    "N*mm": _unit("1/1000", TORQUE),
    "N*cm": _unit("1/100", TORQUE),
    "kgf*m": _unit("9.80665", TORQUE),
    "kN*m": _unit(1000, TORQUE),
    "g": _unit("1/1000", MASS),
    "kg": _unit(1, MASS),
    "t": _unit(1000, MASS),
    "Pa": _unit(1, PRESSURE),
    "kPa": _unit(1000, PRESSURE),
    "MPa": _unit(1000000, PRESSURE),
    "GPa": _unit(1000000000, PRESSURE),
    "bar": _unit(100000, PRESSURE),
    "N/mm^2": _unit(1000000, PRESSURE),
    "s": _unit(1, TIME),
    "ms": _unit("1/1000", TIME),
    "min": _unit(60, TIME),
    "m/s": _unit(1, VELOCITY),
    "mm/s": _unit("1/1000", VELOCITY),
    "m/s^2": _unit(1, ACCELERATION),
    "mm/s^2": _unit("1/1000", ACCELERATION),
    "N/m": _unit(1, STIFFNESS),
    "N/mm": _unit(1000, STIFFNESS),
    "kN/m": _unit(1000, STIFFNESS),
    "deg/s": _unit("1/180", FREQUENCY, pi=True),
    "rad/s": _unit(1, FREQUENCY),
    "rpm": _unit("1/30", FREQUENCY, pi=True),
    "Hz": _unit(1, FREQUENCY),
    "W": _unit(1, POWER),
    "kW": _unit(1000, POWER),
    "J": _unit(1, TORQUE),
    "1/m": _unit(1, Dimension(-1)),
    "1/mm": _unit(1000, Dimension(-1)),
    "1/s": _unit(1, FREQUENCY),
}
"""Every unit a number may carry, longest match first when read (``N*mm`` before ``N``)."""
