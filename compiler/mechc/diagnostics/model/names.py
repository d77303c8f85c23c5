"""Messages for names: unknown, taken twice, out of place, in a cycle (E20x)."""

import re
from collections.abc import Collection, Iterable, Sequence

from ...source import Span
from ...units import UNITS
from ..diagnostic import Message, Related, coded, near_miss
from ..syntax import listed

MOST_LISTED_NAMES = 6
"""Names that are listed where none is near."""

MOST_COMPARED_NAMES = 200
"""Names among which no near miss is looked for: thousands of errors would take minutes."""


def near(name: str, known: Collection[str]) -> str:
    """Return the question whether a name that is spelled alike is meant, '' if there is none."""
    return near_miss(name, sorted(known)) if len(known) <= MOST_COMPARED_NAMES else ""


def offered(name: str, known: Collection[str], what: str) -> str:
    """Return the near miss, or the names themselves where they are few.

    >>> offered("G", ["P", "F"], "loads")
    'the loads are F and P'
    >>> offered("alhpa", ["alpha", "beta"], "parameters")
    "did you mean 'alpha'?"
    """
    if found := near(name, known):
        return found
    known = sorted(known)
    if not known:
        return f"there are no {what}"
    *front, last = known
    if not front:
        return f"the only one of the {what} is {last}"
    if len(known) <= MOST_LISTED_NAMES:
        return f"the {what} are {', '.join(front)} and {last}"
    return f"some of the {what}: {', '.join(known[:MOST_LISTED_NAMES])}"


@coded("E201")
def unknown_name(
    span: Span, name: str, known: Collection[str], hint: str = "", use: Span | None = None
) -> Message:
    """An expression mentions a name that nothing declares.

    A name in an expression is a parameter, a load, or the name of a ``find`` or ``let``.
    Points are no quantities: an expression names them only inside ``V_D`` and its kin.

        param a = 40 mm
        OB = aa @ 90 deg             # wrong: there is no aa
        OB = a @ 90 deg              # right
        AC = b @ AB + 30 deg         # wrong: AB is a direction by itself only
        angle BAC = 30 deg           # right
    """
    hint = hint or near(name, known) or _declare_it(name, known)
    related = (Related(use, "this brings in the names with its prefix"),) if use else ()
    return Message(span, f"the name '{name}' is not declared", hint, related)


FORCES_CHECKED = (
    "a sheet checks what results come to: `mechc new pin --sheet`, with a line "
    '`use "clamp.mech" as C (F = 2 kN)`'
)
"""The hint at a condition on a force: the code of a mechanism takes loads of any size."""


def _declare_it(name: str, known: Collection[str]) -> str:
    """Return the hint at a name that is like none: it is to be declared, or another is meant.

    >>> _declare_it("phi", ["l", "r"])
    "declare it, 'param phi = …'; the names declared are l and r"
    """
    return f"declare it, 'param {name} = …'; {offered(name, known, 'names declared')}"


def points_in_small(name: str, raised: str) -> str:
    """Return the hint at the name of a place or vector whose points are in small letters."""
    return f"points are capital letters: {raised}, not {name}"


def of_no_point(name: str, points: Collection[str]) -> str:
    """Return the hint at the name of a place of which there is no point.

    >>> of_no_point("y_Z", ["A", "O"])
    'y_Z is said of a point, and the points are A and O'
    """
    return f"{name} is said of a point, and the points are {listed(sorted(points), 'and')}"


def dimension_as_value(name: str) -> str:
    """Return the hint at a kind of quantity where a value belongs."""
    return f"a quantity without a value is written `param a: {name}`"


def point_as_quantity(name: str) -> str:
    """Return the hint at the name of a point in a formula or a direction."""
    return (
        f"{name} is a point: its coordinates are x_{name} and y_{name}, "
        "and a direction is an angle, x, -x, y, -y, or one between points, AB"
    )


def power_of_unit(name: str) -> str:
    """Return the hint at a unit with its power behind it, '' for other names.

    Metres are left out: ``m2`` may be a mass.

    >>> power_of_unit("mm2"), power_of_unit("m2")
    ("a power of a unit is written with '^': mm^2", '')
    """
    unit, power = name[:-1], name[-1:]
    is_power = len(unit) > 1 and unit in UNITS and power in "234"
    return f"a power of a unit is written with '^': {unit}^{power}" if is_power else ""


SECONDS = {"sec": "s", "second": "s", "minute": "min", "hr": "h", "hour": "h"}
"""How times are spelled in units."""


def rest_of_unit(before: str, name: str) -> str:
    """Return the hint at a name that ends the unit of a number, '' where it ends none.

    >>> rest_of_unit("param g = 9.81 m/", "s2"), rest_of_unit("let v = 3 mm/", "sec")
    ("did you mean 'm/s^2'?", "did you mean 'mm/s'?")
    >>> rest_of_unit("let q = F/", "m2")
    ''
    """
    number = re.search(r"(?<![\w])[\d.]+ ?([A-Za-z]+[*/])$", before)
    last = re.sub(r"(?<=[a-z])(?=[234]$)", "^", SECONDS.get(name, name))
    unit = number[1] + last if number else ""
    return meant(unit) if unit in UNITS else ""


def load_follows(used: str, prefix: str, given: str) -> str:
    """Return the hint at a load of a used mechanism that is undetermined until one is given."""
    written = f'"{used}"' if "." in used else used
    return f"it follows once a load is given: use {written} as {prefix} ({given} = …)"


def unit_alone(unit: str) -> str:
    """Return the hint at a unit that stands without a number, as behind a stroke.

    >>> unit_alone("min"), unit_alone("rev")
    ("a unit stands behind its number: '12 1/min'", "a unit stands behind its number: '1 rev'")
    """
    shown = f"12 1/{unit}" if f"1/{unit}" in UNITS else f"1 {unit}"
    hint = f"a unit stands behind its number: '{shown}'"
    return f"declare it, 'param psi = …'; {hint}" if unit == "psi" else hint


def for_a_turn(before: str, name: str) -> str:
    """Return the hint at a pitch that is written as one for a turn, '' for other names.

    >>> for_a_turn("screw A pitch 6 mm/", "rev"), for_a_turn("let n = v/", "rev")
    ('a pitch is the length for one turn: pitch 6 mm', '')
    """
    pitch = re.search(r"(pitch:? [\d.]+ ?[A-Za-z]+)/$", before)
    return f"a pitch is the length for one turn: {pitch[1]}" if pitch and name == "rev" else ""


def thread_by_name(before: str, name: str) -> str:
    """Return the hint at a metric thread that stands for its diameter, '' for other names.

    >>> thread_by_name("friction screw A 0.1 thread ", "M20"), thread_by_name("let M = ", "M20")
    ('a thread has its mean diameter there, somewhat less than the 20 mm of M20', '')
    """
    size = re.fullmatch(r"M([1-9]\d*)", name)
    if not size or not before.endswith("thread "):
        return ""
    return f"a thread has its mean diameter there, somewhat less than the {size[1]} mm of {name}"


def meant(name: str) -> str:
    """Return the question whether a name is meant that is known to be close."""
    return f"did you mean {name!r}?"


def found_if_asked(used: str, result: str, alike: Sequence[str]) -> str:
    """Return the hint at a result that a used mechanism does not ask for, or by another name."""
    has = f"; as it is, it gives {', '.join(alike)}" if 0 < len(alike) <= MOST_LISTED_NAMES else ""
    return f"{used} gives it once it has a line `find {result}`{has}"


def no_such_points(used: str, strange: Sequence[str], points: Sequence[str]) -> str:
    """Return the hint at a result of a used mechanism that is one of points it does not have."""
    return f"{used} has no point {' or '.join(strange)}; its points are {', '.join(points)}"


def named_by_a_let(used: str, prefix: str, quantity: str) -> str:
    """Return the hint at what a used mechanism has by itself: a length, a place, a weight."""
    return f"with a line `let q = {quantity}` {used} gives it as '{prefix}_q'"


def without_friction(used: str) -> str:
    """Return the hint at a result with friction of a used mechanism that has none."""
    return f"{used} has no friction"


NEGATIVE_RADIUS = "behind this word a negative radius stands in brackets: radius (-5 mm)"
"""The hint at ``rack A on O radius -5 mm``, which takes 5 mm off a quantity of that name."""


def vector_as_quantity(vector: str, posed: bool) -> str:
    """Return the hint at a vector in a formula, where what was found may be mentioned or not."""
    if posed:
        return f"the direction of {vector} is phi_{vector}, its length len_{vector}"
    return (
        f"{vector} is a direction by itself only; 'perp {vector}' is {vector} turned by 90 deg, "
        f"and {angle_from_vector()}"
    )


def axis_in_words(word: str, axis: str) -> str:
    """Return the hint at a direction in everyday words."""
    return f"{word} is written {axis}; a direction is an angle, x, -x, y, -y, or AB"


PLANAR = "a mechanism is planar: its directions are x, -x, y, -y, an angle, or AB"
"""The hint at a direction out of the plane."""


def with_friction(name: str) -> str:
    """Return the hint at a result with friction of a mechanism that has none."""
    return f"{name} comes with friction, as by a line `friction pins 0.1 diameter 10 mm`"


def angle_from_vector() -> str:
    """Return the hint at a direction that is not free to be added to."""
    return "an angle from a vector is given by `angle ABC = …`"


@coded("E202")
def unknown_point(span: Span, point: str, known: Collection[str], hint: str = "") -> Message:
    """A statement names a point that stands on no link, pivot or slider.

    Points come into being with ``link``, ``pivot`` and ``slider``. A vector, a load or
    a velocity may then name them.

        link  OA
        force P at B along x     # wrong: no link goes through B
        force P at A along x     # right
    """
    hint = hint or offered(point, known, "points") or "declare it: a link is named by its points"
    return Message(span, f"point {point} stands on no link, pivot or slider", hint)


def undeclared_link(name: str, links: Collection[str]) -> str:
    """Return the hint at a point in the name of a link that nothing declares."""
    return f"{offered(name, links, 'links')}; `link {name}` would declare one"


def point_of_link(point: str, links: Collection[str]) -> str:
    """Return the hint at a point that is drawn and is on no link, '' where there are none."""
    link = max(links, key=len, default="")
    return (
        f"a point is named by the link that carries it, as in `link {link}{point}`" if link else ""
    )


@coded("E203")
def unknown_link(span: Span, points: str, known: Collection[str], hint: str = "") -> Message:
    """Points are named as a link, but no one link carries them all.

    A link is named by two or more of its points in any order.

        link OAH
        link AB
        torque M on OB     # wrong: O and B are on different links
        torque M on OA     # right: the link OAH
    """
    hint = hint or offered(points, known, "links")
    return Message(span, f"no link carries the points {points} together", hint)


def telescope_as_link(points: str) -> str:
    """Return the hint at a telescope that is named where a rigid body is wanted."""
    return (
        f"{points} is a telescope of two parts: loads and slots are on rigid links, and the force "
        "along it is that of its actuator or spring: find that by its name"
    )


@coded("E204")
def ambiguous_link(span: Span, points: str, candidates: Iterable[str]) -> Message:
    """Points are named as a link, but several links carry them.

    link OAB
    link ABC
    torque M on AB      # wrong: which of the two?
    torque M on ABC     # right
    """
    names = " and ".join(sorted(candidates))
    return Message(span, f"{points} may be any of the links {names}", "name it by all its points")


@coded("E205")
def repeated_point(span: Span, points: str, point: str) -> Message:
    """A list of points has the same point twice.

    A link goes through each of its points once, and a vector leads from one point to
    another.

        link OBO     # wrong
        link OBA     # right
    """
    return Message(span, f"{points} has the point {point} twice", "each point stands there once")


@coded("E206")
def name_taken(span: Span, name: str, kind: str, first: Span, first_kind: str) -> Message:
    """Two things have the same name.

    Parameters, loads, finds and lets share one world of names, in which each is unique.
    Points are another world: a force ``P`` beside a point ``P`` is fine. A ``let`` with
    a load's name is no second thing: it gives the load its value.

        param P = 40 mm
        force P at A along x     # wrong
        force F at A along x     # right
    """
    related = (Related(first, f"{first_kind} '{name}' is declared here"),)
    if kind == first_kind:
        return Message(span, f"{kind} '{name}' is declared twice", "remove or rename one", related)
    by_let = f"rename one; a load has its value by `let {name} = …`, and needs no parameter"
    hint = by_let if {kind, first_kind} == {"load", "parameter"} else "rename one"
    return Message(span, f"{kind} '{name}' has the name of a {first_kind}", hint, related)


@coded("W258")
def look_alike(span: Span, name: str, other: str, first: Span) -> Message:
    """Two names are written alike in formulas, so that a reader takes them for one quantity.

    A number at the end of a letter is its index, as is what stands behind an underscore;
    ``lam`` and ``eps`` are lambda and epsilon::

        param l1 = 40 mm
        param l_1 = 60 mm     # warned of: both are l with the index 1
        param l_2 = 60 mm     # right
    """
    related = (Related(first, f"'{other}' is declared here"),)
    message = f"'{name}' and '{other}' are written alike in formulas"
    return Message(span, message, "rename one", related)


@coded("E214")
def list_of_values(span: Span, name: str, kind: str) -> Message:
    """A name has a list of values, where YAML takes one.

    A list of two stands for two things of one name.

        P: [{at: A, along: x}, {at: B, along: y}]    # wrong
        P: {at: A, along: x}                         # right
    """
    message = f"{kind} '{name}' has a list of values, expected one"
    hint = f"write {name}: … without brackets, or two names"
    if kind == "let":
        choice = 'a choice is one text in quotes, "1.1 when v < 1 m/s else 1.3"'
        hint = f"write {name}: … without brackets; {choice}"
    return Message(span, message, hint)


def asked_for_a_value(kind: str, name: str) -> str:
    """Return the hint at a table or list that stands for a value of it, '' for other kinds.

    >>> asked_for_a_value("table", "impact"), asked_for_a_value("load", "P")
    ("its value stands behind 'at', in a let of its own: let q = impact at …", '')
    """
    match kind:
        case "table":
            return f"its value stands behind 'at', in a let of its own: let q = {name} at …"
        case "list":
            return f"a size of it is asked for in a let of its own: let D = next … in {name}"
        case _:
            return ""


@coded("E207")
def name_out_of_place(span: Span, name: str, kind: str, wanted: str, hint: str = "") -> Message:
    """A name is declared, but may not stand in this formula.

    Geometry, directions and values of parameters are made of parameters (and of ``let``s
    that use parameters only), since loads and results are known only after them. Loads
    and results may stand in a ``let``.

        OB = P @ 90 deg     # wrong where P is a force
    """
    hint = hint or f"make the formula of {wanted} alone"
    return Message(span, f"'{name}' is {kind}, expected {wanted}", hint)


@coded("E208")
def circular_definition(span: Span, cycle: list[str], places: list[Span]) -> Message:
    """Definitions need one another in a cycle, so none of them has a value.

    param a = 2*b
    param b = a/2     # wrong
    param b = 3 mm    # right
    """
    if len(set(cycle)) == 1:
        message = f"'{cycle[0]}' is defined by itself"
    else:
        message = f"these definitions form a cycle: {' → '.join(cycle)}"
    related = tuple(Related(p, "and here") for p in places)
    return Message(span, message, "give one of them a value", related)


@coded("E209")
def reserved_form(span: Span, name: str, meaning: str) -> Message:
    """A name has the form that the language keeps for quantities of a point or link.

    ``V_D``, ``omega_OB``, ``R_O``, ``N_AB``, ``phi_AB`` and ``len_AB`` are quantities of
    the mechanism itself wherever they stand, so nothing else is called like that.

        param R_O = 40 mm     # wrong
        param R_o = 40 mm     # right: 'o' is no point
    """
    return Message(span, f"'{name}' means {meaning} and cannot be declared", "choose another name")
