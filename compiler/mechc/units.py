"""Units and dimensions: one table, exact factors.

Inside, everything is SI and radians; outside, the units the user wrote. The factor of
an angle unit in degrees is a rational multiple of π, so :class:`Unit` keeps it apart:
``deg`` has factor 1/180 and ``pi`` True.
"""

import math
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction

from .base.named import NamedTuple


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
    >>> described(Dimension(-1)), described(FORCE.joined(Dimension(2)))
    ('a quantity in 1/m', 'a quantity in N*m^2')
    """
    if dimension == NUMBER:
        return "a pure number"
    for name, known in DIMENSIONS.items():
        if known == dimension:
            return f"{'an' if name[0] in 'aeiou' else 'a'} {name} ({USUAL_UNITS[known]})"
    return f"a quantity in {_in_newtons(dimension)}"


def _in_newtons(dimension: Dimension) -> str:
    """Return a dimension in newtons and metres where that is what it is made of."""
    forces = dimension.mass
    if forces and dimension.time == -2 * forces:
        return _quotient((("N", forces), ("m", dimension.length - forces)))
    return base_units(dimension)


def base_units(dimension: Dimension) -> str:
    """Return a dimension in SI base units.

    >>> base_units(FORCE)
    'kg*m/s^2'
    """
    return _quotient((("kg", dimension.mass), ("m", dimension.length), ("s", dimension.time)))


def _quotient(powers: Sequence[tuple[str, int | Fraction]]) -> str:
    """Return units to their powers, those that divide behind a stroke."""
    above = [_raised(unit, e) for unit, e in powers if e > 0]
    below = [_raised(unit, -e) for unit, e in powers if e < 0]
    return "/".join(["*".join(above) or "1", *below])


def _raised(unit: str, exponent: int | Fraction) -> str:
    if exponent == 1:
        return unit
    return f"{unit}^{exponent}" if Fraction(exponent).denominator == 1 else f"{unit}^({exponent})"


_SI: dict[Dimension, str] = {
    NUMBER: "",
    ANGLE: "rad",
    LENGTH: "m",
    DIMENSIONS["area"]: "m^2",
    DIMENSIONS["volume"]: "m^3",
    MASS: "kg",
    TIME: "s",
    FORCE: "N",
    TORQUE: "N*m",
    PRESSURE: "Pa",
    VELOCITY: "m/s",
    ACCELERATION: "m/s^2",
    STIFFNESS: "N/m",
    POWER: "W",
    FREQUENCY: "1/s",
}


def si_unit(dimension: Dimension) -> str:
    """Return the SI unit of a dimension, '' for a bare number.

    >>> si_unit(FORCE), si_unit(Dimension(-1))
    ('N', '1/m')
    """
    return _SI[dimension] if dimension in _SI else base_units(dimension)


class Unit(NamedTuple):
    """A unit: its factor to SI, exact, times π when ``pi``, and its dimension."""

    factor: Fraction
    dimension: Dimension
    pi: bool = False

    @property
    def size(self) -> float:
        """Return one of the unit in SI, to the last digit of a float."""
        return float(self.factor) * (math.pi if self.pi else 1.0)


def _unit(factor: str | int, dimension: Dimension, pi: bool = False) -> Unit:
    return Unit(Fraction(factor), dimension, pi)


INCH = Fraction(254, 10000)
POUND = Fraction(45359237, 100000000)
GRAVITY = Fraction(980665, 100000)
POUND_FORCE = POUND * GRAVITY

SIMPLE: dict[str, Unit] = {
    "mm": _unit("1/1000", LENGTH),
    "cm": _unit("1/100", LENGTH),
    "dm": _unit("1/10", LENGTH),
    "m": _unit(1, LENGTH),
    "km": _unit(1000, LENGTH),
    "um": _unit("1/1000000", LENGTH),
    "\u00b5m": _unit("1/1000000", LENGTH),
    "\u03bcm": _unit("1/1000000", LENGTH),
    "in": Unit(INCH, LENGTH),
    "inch": Unit(INCH, LENGTH),
    '"': Unit(INCH, LENGTH),
    "ft": Unit(12 * INCH, LENGTH),
    "yd": Unit(36 * INCH, LENGTH),
    "deg": _unit("1/180", ANGLE, pi=True),
    "°": _unit("1/180", ANGLE, pi=True),
    "rad": _unit(1, ANGLE),
    "mrad": _unit("1/1000", ANGLE),
    "rev": _unit(2, ANGLE, pi=True),
    "N": _unit(1, FORCE),
    "daN": _unit(10, FORCE),
    "kN": _unit(1000, FORCE),
    "MN": _unit(1000000, FORCE),
    "kgf": Unit(GRAVITY, FORCE),
    "lbf": Unit(POUND_FORCE, FORCE),
    "ozf": Unit(POUND_FORCE / 16, FORCE),
    "kip": Unit(1000 * POUND_FORCE, FORCE),
    "g": _unit("1/1000", MASS),
    "kg": _unit(1, MASS),
    "t": _unit(1000, MASS),
    "lb": Unit(POUND, MASS),
    "oz": Unit(POUND / 16, MASS),
    "Pa": _unit(1, PRESSURE),
    "kPa": _unit(1000, PRESSURE),
    "MPa": _unit(1000000, PRESSURE),
    "GPa": _unit(1000000000, PRESSURE),
    "bar": _unit(100000, PRESSURE),
    "psi": Unit(POUND_FORCE / INCH**2, PRESSURE),
    "ksi": Unit(1000 * POUND_FORCE / INCH**2, PRESSURE),
    "s": _unit(1, TIME),
    "ms": _unit("1/1000", TIME),
    "min": _unit(60, TIME),
    "mph": Unit(63360 * INCH / 3600, VELOCITY),
    "rpm": _unit("1/30", FREQUENCY, pi=True),
    "W": _unit(1, POWER),
    "kW": _unit(1000, POWER),
}
"""The units of one word."""

PARTS = SIMPLE | {
    "h": _unit(3600, TIME),
    "l": _unit("1/1000", DIMENSIONS["volume"]),
    "1": _unit(1, NUMBER),
}
"""What compounds are made of; behind a number alone, h and l are more likely to be lengths."""

COMPOUNDS = """
    mm^2 cm^2 dm^2 m^2 in^2 ft^2 mm^3 cm^3 dm^3 m^3 in^3 ft^3 mm^4 cm^4 m^4 in^4
    m^3/s m^3/h cm^3/s l/min
    kg*m^2 kg*cm^2 kg/m^3 g/cm^3
    N*m N*mm N*cm kN*m kN*mm daN*m kgf*m kgf*cm kgf*mm
    lbf*ft ft*lbf lbf*in in*lbf ozf*in in*ozf
    N/mm^2 N/cm^2 N/m^2 kN/m^2 kgf/cm^2 kgf/mm^2 lbf/in^2
    N*m/rad N*mm/rad N*cm/rad lbf*in/rad
    N/m N/cm N/mm kN/m kN/mm kgf/cm kgf/mm lbf/in lbf/ft
    m/s mm/s cm/s km/h m/min mm/min in/s in/min ft/s ft/min
    m/s^2 mm/s^2 cm/s^2 in/s^2 ft/s^2
    rad/s deg/s °/s rev/s rev/min rad/m rad/mm 1/s 1/min 1/m 1/mm 1/in
"""
"""The units made of others that are read behind a number, the usual ones only.

``5 N*mass`` is a product with a parameter, and so is ``2 m*g``.
"""


def of_length(unit: str, dimension: Dimension) -> str:
    """Return a unit of length, raised to what a dimension is a power of it; '' for any other.

    >>> of_length("mm", LENGTH), of_length("mm", LENGTH.scaled(2)), of_length("mm", FORCE)
    ('mm', 'mm^2', '')
    """
    raised = unit if dimension == LENGTH else f"{unit}^{dimension.length}"
    return raised if raised in UNITS and UNITS[raised].dimension == dimension else ""


def compound(spelled: str) -> Unit:
    """Return the unit that simple ones make with ``*``, ``/`` and powers.

    >>> compound("m/s^2") == Unit(Fraction(1), ACCELERATION)
    True
    """
    factor, dimension, pi = Fraction(1), NUMBER, False
    for sign, word, power in re.findall(r"([*/]?)([^*/^]+)(?:\^(\d))?", spelled):
        part = PARTS[word]
        exponent = int(power or 1) * (-1 if sign == "/" else 1)
        factor *= part.factor**exponent
        dimension = dimension.joined(part.dimension.scaled(exponent))
        pi = pi or part.pi
    return Unit(factor, dimension, pi)


class UnitTable(Mapping[str, Unit]):
    """Units by how they are spelled; those made of others are found when they are asked for."""

    def __init__(self, known: Mapping[str, Unit], spelled: Iterable[str]) -> None:
        """Take the units that are known, and how all are spelled."""
        self._known, self._spelled = dict(known), dict.fromkeys(spelled)

    def __getitem__(self, spelled: str) -> Unit:
        if spelled not in self._known and spelled in self._spelled:
            self._known[spelled] = compound(spelled)
        return self._known[spelled]

    def __contains__(self, spelled: object) -> bool:
        return spelled in self._spelled

    def __iter__(self) -> Iterator[str]:
        return iter(self._spelled)

    def __len__(self) -> int:
        return len(self._spelled)


ALIKE = {"J": _unit(1, TORQUE), "Hz": _unit(1, FREQUENCY)}
"""Units of one word that are like compounds."""

UNITS = UnitTable(SIMPLE | ALIKE, (*SIMPLE, *COMPOUNDS.split(), *ALIKE))
"""Every unit a number may carry, longest match first when read (``N*mm`` before ``N``)."""

SPELLINGS = {"\u00b5m": "um", "\u03bcm": "um", "inch": "in", '"': "in", "°": "deg"}
"""Other spellings of simple units, by the one of this table that languages know."""

DEGREES = ("deg", "°")

GLUED = ("°", '"')
"""Signs of units that stand at their number without a space."""


def behind(unit: str) -> str:
    """Return a unit as it stands behind its number, with a space where it is a word.

    >>> behind("mm"), behind("°"), behind("")
    (' mm', '°', '')
    """
    return unit if not unit or unit.startswith(GLUED) else f" {unit}"


def size_of(unit: str) -> float:
    """Return a unit in the SI; one that no table has is of the SI, and so is none at all.

    >>> size_of("mm"), size_of("")
    (0.001, 1.0)
    """
    return UNITS[unit].size if unit in UNITS else 1.0


def in_unit(value: float, unit: str, digits: int) -> str:
    """Return an SI value to so many digits in a unit; one that no table has is of the SI.

    >>> in_unit(0.1, "mm", 6), in_unit(math.pi / 15, "°", 6), in_unit(0.5, "", 6)
    ('100 mm', '12°', '0.5')
    >>> in_unit(2e-7, "deg", 4)
    '0.00001146 deg'
    """
    figures = f"{value / size_of(unit):.{digits}g}"
    return (small_angle(figures) if unit in DEGREES else figures) + behind(unit)


def small_angle(figures: str) -> str:
    """Return the figures of an angle in degrees, without a power of ten where it is small.

    >>> small_angle("-2e-05"), small_angle("2.5e-16"), small_angle("30")
    ('-0.00002', '2.5e-16', '30')
    """
    mantissa, is_small, exponent = figures.partition("e-0")
    places = len(mantissa.partition(".")[2]) + int(exponent or 0)
    return f"{float(figures):.{places}f}" if is_small else figures
