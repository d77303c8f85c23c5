"""What quantities without a text are, by what the description does with them.

>>> from ..source import Span
>>> f, d = Symbol("f"), Symbol("d")
>>> circle = product([(f, 1), (d, 1), (HALF, 1)])
>>> of_friction(PinFriction("O", "", circle, Span(0, 0)), frozenset({"d"}))
[('f', 'coefficient'), ('d', 'pin')]
"""

from collections import Counter
from collections.abc import Container, Iterable, Iterator, Mapping, Set
from typing import assert_never

from ..base.frozen import replace
from ..formula.names import split_points
from ..formula.tree import HALF, Formula, Number, Product, Sum, Symbol, product
from ..formula.walk import walk
from ..model.mechanism import (
    Arrow,
    Force,
    ForcePair,
    Geometry,
    Mechanism,
    Offset,
    Parameter,
    Turn,
    WheelPair,
)
from ..model.parts.friction import (
    CollarFriction,
    FaceFriction,
    GuideFriction,
    JointFriction,
    PinFriction,
    PivotFriction,
    RopeFriction,
    ThreadFriction,
    WheelFriction,
    coulomb,
)
from ..units import FORCE, LENGTH

Role = tuple[str, str]
"""A quantity, and what it is: a key of the words of a language."""


PLACES = {"x": "coordinate", "y": "coordinate", "r": "radius", "p": "pitch"}
"""The words for sizes at a point, by the letter of their names."""

SEVERAL = {"pin": "pins", "rate": "rates", "free length": "free lengths"}
"""The words for what several parts have."""


def with_roles(
    parameters: Iterable[Parameter], mechanism: Mechanism, words: Mapping[str, str]
) -> Iterator[Parameter]:
    """Yield quantities with what they are for a text, where they have none of their own."""
    roles = dict((*_of_loads(mechanism), *_roles(mechanism)))
    for parameter in parameters:
        role = "" if parameter.label or parameter.about else roles.get(parameter.name, "")
        yield replace(parameter, label=words[role]) if role else parameter


def with_places(
    parameters: Iterable[Parameter], mechanism: Mechanism, words: Mapping[str, str]
) -> Iterator[Parameter]:
    """Yield quantities; coordinates and radii with the point, components with the vector.

    These are numbers in the description, or parameters that are nothing but one coordinate.
    """
    literals = {literal.name for literal in mechanism.literals}
    made = literals | {name for turn in mechanism.geometry for name in _drawn_angle(turn)}
    sizes, pulleys = _sizes(mechanism.geometry), {*_pulleys(mechanism)}
    for parameter in parameters:
        name = parameter.name
        role, of = _place(name, mechanism.spans) if name in made else sizes.get(name, ("", ""))
        role = "pulley" if role == "radius" and name in pulleys else role
        is_bare = role and not parameter.label and not parameter.about
        yield replace(parameter, label=words[role].format(point=of)) if is_bare else parameter


def _pulleys(mechanism: Mechanism) -> Iterator[str]:
    """Yield the names of the radii of the wheels on which a belt or chain runs."""
    for pair in mechanism.each(WheelPair):
        if pair.kind == "belt":
            radii = (pair.first_radius, pair.second_radius)
            yield from (radius.name for radius in radii if isinstance(radius, Symbol))


def _sizes(geometry: Iterable[Geometry]) -> dict[str, Role]:
    """Return the quantities that are nothing but one coordinate or component, and of what it is."""
    met: dict[str, list[Role]] = {}
    for item in geometry:
        if isinstance(item, Offset):
            of = "component" if item.tail else "coordinate"
            for axis, size in (("x", item.x), ("y", item.y)):
                if isinstance(size, Symbol):
                    met.setdefault(size.name, []).append((f"{axis} {of}", item.tail + item.head))
        elif isinstance(item, Arrow) and isinstance(item.length, Symbol):
            met.setdefault(item.length.name, []).append(("", ""))
    return {name: roles[0] for name, roles in met.items() if len(roles) == 1}


def _drawn_angle(item: Geometry) -> tuple[str, ...]:
    """Return the name of an angle of a link that a drawing gives, if an entry is one."""
    if isinstance(item, Turn) and isinstance(item.angle, Symbol):
        corner = f"delta_{item.first}{item.vertex}{item.second}"
        return (corner,) if item.angle.name == corner else ()
    return ()


def _place(name: str, points: Container[str]) -> tuple[str, str]:
    """Return the word for a size at a point and the point, by its name; of others two empty words.

    >>> _place("x_O", {"O"}), _place("y_D0", {"D"}), _place("delta_BAG", {}), _place("len_AB", {})
    (('coordinate', 'O'), ('guide', 'D'), ('angle', 'BAG'), ('', ''))
    >>> _place("r_O1_2", {"O1"})
    ('radius', 'O1')
    >>> _place("y_OA", {"O", "A"})
    ('y component', 'OA')
    """
    kind, _, of = name.partition("_")
    point, _, number = of.rpartition("_")
    if number.isdigit() and of not in points:
        of = point
    if kind == "delta":
        return "angle", of
    if kind in ("x", "y") and of not in points and of.removesuffix("0") in points:
        return "guide", of.removesuffix("0")
    if kind in ("x", "y") and _joins(of, points):
        return f"{kind} component", of
    return (PLACES[kind], of) if kind in PLACES and of in points else ("", "")


def _joins(name: str, points: Container[str]) -> bool:
    """Return whether a name is that of a vector between two of the points."""
    ends = ["".join(end) for end in split_points(name)]
    return len(ends) > 1 and all(end in points for end in ends)


def _roles(mechanism: Mechanism) -> Iterator[Role]:
    known = (*mechanism.parameters, *mechanism.literals)
    lengths = frozenset(p.name for p in known if p.dimension == LENGTH)
    met = Counter(r for f in mechanism.friction.joints for r in of_friction(f, lengths))
    ties = (k.tie for k in mechanism.loads if isinstance(k, ForcePair) and k.spring)
    met += Counter(role for tie in ties if tie for role in _of_spring(tie))
    roles = Counter(name for name, _ in met)
    for (name, role), times in met.items():
        if roles[name] == 1:  # what is a diameter here and a free length there is neither alone
            yield name, SEVERAL.get(role, role) if times > 1 else role


def _of_loads(mechanism: Mechanism) -> Iterator[Role]:
    """Yield loads as forces and couples, masses of weights, intensities of what is spread."""
    for load in mechanism.loads:
        yield load.name, "force" if load.dimension == FORCE else "couple"
        if isinstance(load, Force) and load.weight:
            match load.tie:
                case Product((Number(), Symbol(mass))):
                    yield mass, "mass"
        if isinstance(load, Force) and load.spread:
            for intensity in load.spread.intensities:
                yield from _named(intensity, "intensity")


def of_friction(friction: JointFriction, lengths: Set[str]) -> list[Role]:
    """Return the quantities of a friction with their roles."""
    match friction:
        case PinFriction(radius=radius):
            return _of_circle(radius, lengths)
        case CollarFriction(factor=factor, radius=radius):
            return [*_named(factor, "coefficient"), *_of_mean(radius)]
        case GuideFriction() | FaceFriction() | PivotFriction():
            return _named(friction.factor, "coefficient")
        case RopeFriction(coefficient=coefficient, wrap=wrap):
            return [*_named(coefficient, "coefficient"), *_named(wrap, "wrap")]
        case ThreadFriction(factor=factor, thread=thread):
            return [*_named(factor, "coefficient"), *_named(thread, "thread")]
        case WheelFriction(factor=factor):
            return _named(factor, "loss")
        case _:
            assert_never(friction)


def _of_circle(radius: Formula, lengths: Set[str]) -> list[Role]:
    """Return the coefficient and the diameter in f·d/2, or by Coulomb's law; of f·r neither."""
    names = dict.fromkeys(part for part in walk(radius) if isinstance(part, Symbol))
    diameters = [name for name in names if name.name in lengths]
    others = [name for name in names if name.name not in lengths]
    if len(diameters) != 1 or len(others) != 1:
        return []
    (d,), (f,) = diameters, others
    circles = (product([(HALF, 1), (law, 1), (d, 1)]) for law in (f, coulomb(f)))
    return [(f.name, "coefficient"), (d.name, "pin")] if radius in circles else []


def _of_mean(radius: Formula) -> list[Role]:
    """Return the mean diameter of a collar in D/2; where the radius is found otherwise nothing.

    >>> _of_mean(product([(Symbol("D_A"), 1), (HALF, 1)])), _of_mean(Symbol("r"))
    ([('D_A', 'collar')], [])
    """
    match radius:
        case Product((Number() as part, Symbol(name))) if part == HALF:
            return [(name, "collar")]
        case _:
            return []


def _of_spring(tie: Formula) -> Iterator[Role]:
    """Yield the rate of a spring, and its free length, where names alone stand for them."""
    match tie:
        case Product((Symbol(rate), Sum((Symbol(free), _)))):
            yield from ((rate, "rate"), (free, "free length"))
        case Product((Symbol(rate), Sum())):
            yield rate, "rate"


def _named(formula: Formula, role: str) -> list[Role]:
    return [(formula.name, role)] if isinstance(formula, Symbol) else []
