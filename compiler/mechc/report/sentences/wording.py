"""A derivation put into words, whatever the language and whoever prints."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from itertools import groupby, pairwise
from typing import TypeVar

from ...algebra.from_formula import to_product
from ...formula.names import direction_of
from ...formula.tree import (
    Call,
    Constant,
    Formula,
    Power,
    Product,
    Symbol,
    product,
    quotient,
)
from ...formula.walk import children, rebuild
from ..languages.locale import Locale
from ..steps import DerivationStep, Equation, PositionStep
from .order import enumeration
from .speller import Speller

WordedKind = TypeVar("WordedKind", bound=str)
"""A rule of velocities, or how a loop is solved."""


def sentences(
    steps: Iterable[DerivationStep], locale: Locale, spell: Callable[[str], str]
) -> Iterator[str]:
    """Yield the rule of each step in words; ``spell`` writes a name of the drawing.

    What is solved together has the rules of all its relations.
    """
    listed = [[*step.reasons, (step.rule, step.subject)] for step in steps]
    kinds = [rule for rules in listed for rule, _ in rules]
    templates = iter(_in_full_once(kinds, locale.rules, locale.again))
    for rules in listed:
        yield " ".join(_sentence(subject, next(templates), locale, spell) for _, subject in rules)


def _in_full_once(
    kinds: Iterable[WordedKind], full: Mapping[WordedKind, str], again: Mapping[WordedKind, str]
) -> Iterator[str]:
    """Yield the template of each kind, from the second one on the short form where it has one."""
    known: set[str] = set()
    for kind in kinds:
        yield again.get(kind, full[kind]) if kind in known else full[kind]
        known.add(kind)


def _sentence(
    subject: Sequence[str], template: str, locale: Locale, spell: Callable[[str], str]
) -> str:
    """Return the sentence of a step; rules name what they are applied to by its place among all.

    ``joined`` are points as one name, ``OAB``; what stands first and is a link has that already.
    """
    first, *others = subject or ("",)
    others = others or [first]
    is_link = len(first.rstrip("'0123456789")) > 1
    return template.format(
        first=spell(first),
        second=spell(others[0]),
        last=spell(others[-1]),
        point=spell(others[-2] if len(others) > 1 else first),
        rest=enumeration(map(spell, others), locale),
        all=enumeration(map(spell, subject), locale),
        joined=spell(first if is_link else "".join(subject)),
    )


def position_sentences(
    steps: Iterable[PositionStep], locale: Locale, spell: Speller
) -> Iterator[str]:
    """Yield in words which loop gives what follows, by which law, in which of two positions."""
    listed = [*steps]
    templates = _in_full_once([step.kind for step in listed], locale.loops, locale.loops_again)
    for step, template in zip(listed, templates, strict=True):
        yield " ".join((_of_loop(step, template, locale, spell), *_introduced(step, locale, spell)))


def _introduced(step: PositionStep, locale: Locale, spell: Speller) -> Iterator[str]:
    """Yield what the names are that a loop finds, and which of two places a point has."""
    if step.corners:
        angles = (
            spell.relation((Symbol(name), Symbol(f"turn_{''.join(corner)}")), ("=",), True)
            for name, corner in step.corners
        )
        yield locale.introduced["corners"].format(corners=enumeration(angles, locale))
    if step.inclined:
        name, part = step.inclined
        symbol = spell.relation((Symbol(name),), (), True)
        yield locale.introduced["inclination"].format(symbol=symbol, part=spell.point(part))
    if step.is_ahead is not None:
        place = "ahead" if step.is_ahead else "behind"
        yield locale.introduced[place].format(pin=spell.point(step.pin))


def _of_loop(step: PositionStep, template: str, locale: Locale, speller: Speller) -> str:
    """Return the sentence on a loop: its points, its turn, and what is found by it."""
    spell = speller.point
    turn = locale.turns["cw" if step.is_clockwise else "ccw"]
    loop, like = (spell("".join(points)) for points in (step.points, step.like))
    side = spell("".join((step.points[0], step.points[-1]))) if step.points else ""
    part = spell(step.part) if step.part else loop
    pins = dict.fromkeys(points[1] for points in (step.points, step.like) if points)
    return template.format(
        loop=loop,
        like=like,
        side=side,
        part=part,
        sides=_legs(step.points, speller),
        found=locale.introduced[_found(step)],
        turn=turn,
        pins=enumeration(map(spell, pins), locale),
        all=enumeration(map(spell, step.points), locale),
    )


def _legs(points: Sequence[str], spell: Speller) -> str:
    """Return that the sides at the middle of three points are equal: ``OB = BK``."""
    legs = tuple(Symbol(f"len_{tail}{head}") for tail, head in pairwise(points[:3]))
    return spell.relation(legs, ("=",) * (len(legs) - 1), False) if legs else ""


def _found(step: PositionStep) -> str:
    """Return the key of what is found of a vector: its direction, its length, or both."""
    is_length = [definition.name.startswith("len_") for definition in step.definitions]
    return "both" if len({*is_length}) > 1 else "length" if any(is_length) else "bearing"


def direction_function(locale: Locale, spell: Speller) -> str:
    """Return the sentence on the value of ``atan2``."""
    x, y = Symbol("x"), Symbol("y")
    names: dict[str, Formula] = {"x": x, "y": y, "function": Call("atan2", (y, x))}
    return locale.atan2.format_map({n: spell.relation((f,), (), True) for n, f in names.items()})


def directions_named(names: Sequence[str], locale: Locale, spell: Speller) -> str:
    """Return the sentence on what the first of the names of directions is, '' where there is none.

    Of several it says that the others are named likewise.
    """
    if not names:
        return ""
    template = locale.introduced["directions" if len(names) > 1 else "direction"]
    x, symbol = (spell.relation((Symbol(n),), (), True) for n in ("x", names[0]))
    return template.format(x=x, symbol=symbol, vector=spell.point(direction_of(names[0])))


def as_ratio(equation: Equation) -> Equation:
    """Return ``V_B/V_A = …`` for ``V_B = V_A·…``, as textbooks print it; others unchanged.

    >>> from ...formula.tree import Call
    >>> from ...formula.to_text import text
    >>> left, right = as_ratio(
    ...     Equation(
    ...         Symbol("V_B"),
    ...         product([(Symbol("V_A"), 1), (Call("cot", (Symbol("alpha"),)), 1)]),
    ...     )
    ... )
    >>> f"{text(left)} = {text(right)}"
    'V_B/V_A = cot(alpha)'

    A velocity and an angular velocity make no ratio: ``V_A = a·omega_OA`` stays.
    """
    match equation:
        case Equation(Symbol(name), Product(factors)) if is_speed(name):
            speeds = [f for f in factors if isinstance(f, Symbol) and is_speed(f.name)]
            others = [f for f in factors if f not in speeds]
            alike = [f for f in speeds if f.name[0] == name[0]]
            if len(alike) == len(speeds) == 1 and not any(_mentions_speed(f) for f in others):
                ratio = quotient(equation.left, speeds[0])
                return Equation(ratio, product((f, 1) for f in others))
    return equation


def is_speed(name: str) -> bool:
    """Return whether a name is a velocity ``V_A`` or an angular velocity ``omega_OA``."""
    return name.startswith(("V_", "omega_"))


def _mentions_speed(factor: Formula) -> bool:
    base = factor.base if isinstance(factor, Power) else factor
    return isinstance(base, Symbol) and is_speed(base.name)


EquationSides = tuple[Formula, ...]
"""Two or more sides of a chain of equations, ``V_D/V_B = OD/OB = b/a``."""


def lines(step: DerivationStep) -> tuple[tuple[EquationSides, ...], tuple[EquationSides, ...]]:
    """Return the equations of a step's rule and those that follow from it, speeds as ratios.

    What follows for the same left side continues its chain; nothing is said twice.
    """
    said = [as_ratio(e) for e in step.relations]
    hence = [e for e in dict.fromkeys(map(as_ratio, step.results)) if e not in said]
    if len(said) == len(hence) == 1 and said[0].left == hence[0].left:
        if to_product(_by_name(said[0].right)) == to_product(_by_name(hence[0].right)):
            return (tuple(said[0]),), ()
        return ((*said[0], hence[0].right),), ()
    return tuple(map(tuple, said)), tuple(_chained(hence))


def _chained(equations: Iterable[Equation]) -> Iterator[EquationSides]:
    """Yield equations, those of a named ratio of speeds as a chain: ``i_B = V_B/V_A = …``."""
    for left, chain in groupby(equations, key=lambda e: e.left):
        if isinstance(left, Symbol) and not is_speed(left.name):
            yield (left, *(e.right for e in chain))
        else:
            yield from map(tuple, chain)


def _by_name(formula: Formula) -> Formula:
    """Return a formula as it is read, a number under a name being but that name."""
    if isinstance(formula, Constant):
        return Symbol(formula.name)
    parts = children(formula)
    return rebuild(formula, tuple(map(_by_name, parts))) if parts else formula
