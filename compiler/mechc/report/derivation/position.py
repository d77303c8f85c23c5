"""Position: what follows from each loop and sum of vectors, in the order in which it follows."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import chain, groupby

from ...base.frozen import replace
from ...base.later import pattern
from ...formula.names import VECTOR_POINTS, corner_of, split_points
from ...formula.rewriting import plus_first
from ...formula.tree import HALF, ONE, Call, Formula, Implicit, Number, Power, Product, Sum
from ...formula.walk import reached, symbols, walk
from ...model.mechanism import ForcePair, Mechanism
from ...model.result import Definition
from ...pose.pose import Pose, SolvedLoop
from ..kinds import PositionKind
from ..steps import Derivation, Equation, PositionStep
from . import equal_sides


def position_steps(pose: Pose, derivation: Derivation) -> Sequence[PositionStep]:
    """Return the loops and sums that a derivation rests on, with what each gives of it."""
    formulas = {d.name: d.formula for d in pose.definitions}
    order = _order(pose, formulas)
    solved = {loop.points: loop for loop in pose.solved}

    def place(step: PositionStep) -> tuple[int, int]:
        """Return where a step stands: one that gives nothing new after the one it is like."""
        names = [d.name for d in step.definitions] or solved[step.points].again
        return min(order[name] for name in names)

    steps = [*_of_loops(pose, derivation, formulas), *_of_sums(pose, derivation, formulas)]
    at_once = list(_put_in(pose, derivation))
    return [*at_once, *sorted(steps, key=place)]


Formulas = Mapping[str, Formula]

_ANOTHER = pattern(r"_\d*$")
"""The end of a name that is another one because its own was taken."""

BETWEEN_ENDS = ("aligned", "vector")
"""The kinds of loops that give the vector between two points."""


def _order(pose: Pose, formulas: Formulas) -> dict[str, tuple[int, int]]:
    """Return where each name comes: those that vectors have put in with what their loop gives."""
    order = {name: (place, 0) for place, name in enumerate(formulas)}
    last = -1
    for number, loop in enumerate(pose.solved, 1):
        last = max([last, *(order[n][0] for n in loop.names if n in order)])
        order |= {d.name: (last, number) for d in loop.put_in}
    return order


def _of_loops(pose: Pose, derivation: Derivation, formulas: Formulas) -> Iterator[PositionStep]:
    """Yield a step for each closed loop that gives an angle or a length which is needed."""
    needed = reached([*_mentioned(derivation), *_in_conditions(derivation)], formulas)
    subjects = [step.subject for step in derivation.steps]
    if not subjects:
        subjects = [link.points for link in pose.mechanism.links]
    fixed = pose.mechanism.fixed
    for loop in pose.solved:
        names = [n for n in loop.names if n in needed]
        put_in = [d for d in loop.put_in if any(map((_ends(d.name) - fixed).issubset, subjects))]
        if names or put_in or not loop.again.isdisjoint(needed):
            shown = (Definition(d.name, plus_first(d.formula)) for d in put_in)
            given = (Definition(n, formulas[n]) for n in names)
            found = (*given, *shown) if loop.kind == "mirrored" else (*shown, *given)
            step = _of_radius(_introduced(loop, _kind(loop, found), found), pose.mechanism)
            if step.kind == "equal":
                step = equal_sides.with_figure(step, {_ends(d.name) for d in found}, pose)
            yield _between_ends(step, pose.mechanism) if loop.kind in BETWEEN_ENDS else step


def _introduced(
    loop: SolvedLoop, kind: PositionKind, found: tuple[Definition, ...]
) -> PositionStep:
    """Return the step of a loop, with what the names are that it finds, and how it is assembled."""
    corners = tuple(_corners(loop, found)) if kind in ("triangle", "congruent") else ()
    inclined = None
    if kind in ("guide", "inclination"):
        named = (d.name for d in found if d.name.startswith("beta_") and _ends(d.name))
        inclined = next(((name, _vector(name)) for name in named), None)
    step = PositionStep(kind, loop.points, loop.is_clockwise, found, loop.like, corners, inclined)
    return replace(step, pin=loop.pin, is_ahead=loop.is_ahead)


def _of_radius(step: PositionStep, mechanism: Mechanism) -> PositionStep:
    """Return a step as that of a circular slot's radius, if that is what it inclines."""
    _, vector = step.inclined or ("", "")
    ends = frozenset("".join(point) for point in split_points(vector))
    if not any(link.arc and ends == frozenset(link.points) for link in mechanism.links):
        return step
    return replace(step, kind="radius" if step.kind == "inclination" else "radius and place")


def _between_ends(step: PositionStep, mechanism: Mechanism) -> PositionStep:
    """Return a step with the vector that it finds alone; one of a telescope says so.

    A parameter that it finds as well, as the direction of a slot, is none.
    """
    vectors = [_vector(definition.name) for definition in step.definitions]
    parts = {v for v in vectors if len(split_points(v)) == VECTOR_POINTS}
    part = min(parts) if len(parts) == 1 else ""
    ends = frozenset("".join(point) for point in split_points(part))
    if len(ends) != VECTOR_POINTS:
        return step
    if not any(ends == frozenset(t.points) for t in mechanism.telescopes):
        return replace(step, part=part)
    pairs = [load for load in mechanism.loads if isinstance(load, ForcePair) and not load.spring]
    is_driven = any(ends == {pair.first, pair.second} for pair in pairs)
    return replace(step, kind="cylinder" if is_driven else "telescope", part=part)


def _corners(
    loop: SolvedLoop, found: Iterable[Definition]
) -> Iterator[tuple[str, tuple[str, str, str]]]:
    """Yield the angles that a triangle finds, with their corners: mu between its unknown sides."""
    first, pin, last = loop.points
    corners = {f"mu_{pin}": (first, pin, last)}
    corners |= {f"gamma_{first}": (pin, first, last), f"gamma_{last}": (first, last, pin)}
    for definition in found:
        if corner := corners.get(definition.name.rstrip("_")):
            yield definition.name, corner


def _ends(direction: str) -> frozenset[str]:
    """Return the points of the vector that a direction is named after.

    >>> sorted(_ends("phi_O1B"))
    ['B', 'O1']
    """
    return frozenset("".join(point) for point in split_points(_vector(direction)))


def _put_in(pose: Pose, derivation: Derivation) -> Iterator[PositionStep]:
    """Yield the loops that give lengths of one product each, as far as velocities have these.

    Such a product stands in place of the length: ``g/cos(alpha)``.
    """
    products = {d.name: d.formula for d in pose.put_in}
    met = [_factors(term) for equation in _equations(derivation) for term in _terms(equation)]
    for loop in pose.solved:
        names = [n for n in loop.names if n in products] if loop.kind == "lengths" else []
        wanted = {n: _factors(products[n]) for n in names}
        names = [n for n in names if any(wanted[n].items() <= has.items() for has in met)]
        if names:
            kind: PositionKind = "lengths" if len(names) > 1 else "length"
            found = tuple(Definition(n, products[n]) for n in names)
            yield PositionStep(kind, loop.points, loop.is_clockwise, found)


def _equations(derivation: Derivation) -> Iterator[Equation]:
    """Yield the relations of velocities, or of forces where loads follow from equilibrium."""
    for step in derivation.steps:
        yield from step.relations
    for explanation in derivation.explanations if not derivation.steps else ():
        for paragraph in explanation.paragraphs:
            yield from (Equation(*sides) for sides in paragraph.equations)


def _terms(equation: Equation) -> Iterator[Formula]:
    for side in equation:
        yield from side.terms if isinstance(side, Sum) else (side,)


def _factors(formula: Formula) -> dict[Formula, Formula]:
    """Return the factors of a product with their exponents, without its number."""
    factors = formula.factors if isinstance(formula, Product) else (formula,)
    powers = (f if isinstance(f, Power) else Power(f, ONE) for f in factors)
    return {p.base: p.exponent for p in powers if not isinstance(p.base, Number)}


_SOLVED = frozenset({"acos", "asin", "atan", "atan2", "hypot", "sqrt"})
"""The functions by which a loop of two unknown parts is solved, whatever its lengths are."""


def _kind(loop: SolvedLoop, found: Sequence[Definition]) -> PositionKind:
    """Return how a loop is solved: by equal lengths where none of its laws was needed.

    One that is like an earlier one is not solved again. Lengths may be equal by their numbers
    alone, as in a parallelogram of four numbers. Where nothing needs the place on a guide, the
    direction is all that is found.
    """
    if loop.like:
        return "congruent"
    is_solved = [any(map(_solves, walk(definition.formula))) for definition in found]
    if loop.kind in ("triangle", "guide", "slot") and not any(is_solved):
        return "equal"
    return "inclination" if loop.kind == "guide" and all(is_solved) else loop.kind


def _solves(part: Formula) -> bool:
    """Return whether a part of a formula comes of a law by which loops are solved."""
    match part:
        case Implicit():
            return True
        case Call(function=function):
            return function in _SOLVED
        case Power(exponent=exponent):
            return exponent == HALF
        case _:
            return False


def _of_sums(pose: Pose, derivation: Derivation, formulas: Formulas) -> Iterator[PositionStep]:
    """Yield the vectors put together of given ones that velocities mention by their names."""
    elsewhere = {n for loop in pose.solved for n in loop.names}
    elsewhere |= {p.name for p in pose.mechanism.parameters}
    mentioned = (_in_steps(derivation), _in_balances(derivation), _in_conditions(derivation))
    needed = reached(chain.from_iterable(mentioned), formulas)
    named = [n for n in formulas if n in needed and n not in elsewhere]
    for vector, names in groupby(named, _vector):
        found = tuple(Definition(n, formulas[n]) for n in names)
        points = tuple("".join(point) for point in split_points(vector))
        is_corner = all(corner_of(definition.name) for definition in found)
        step = PositionStep("angle" if is_corner else "sum", points, None, found)
        yield step if is_corner else _between_ends(step, pose.mechanism)


def _vector(name: str) -> str:
    """Return the vector of ``len_AB``, also where another quantity has that name already.

    >>> _vector("len_AB_"), _vector("phi_AB_2")
    ('AB', 'AB')
    """
    return _ANOTHER.sub("", name.partition("_")[2])


def _in_steps(derivation: Derivation) -> Iterator[str]:
    """Yield the names in the relations of velocities."""
    for step in derivation.steps:
        for equation in (*step.relations, *step.results):
            yield from symbols(equation.right) | symbols(equation.left)


def _in_balances(derivation: Derivation) -> Iterator[str]:
    """Yield the names in the power equations."""
    for balance in derivation.balances:
        yield from symbols(balance.left)


def _in_conditions(derivation: Derivation) -> Iterator[str]:
    """Yield the names in the conditions of use."""
    for condition in derivation.requires:
        yield from symbols(condition.left, condition.right)


def _mentioned(derivation: Derivation) -> Iterator[str]:
    """Yield the names in everything that a derivation prints."""
    yield from _in_steps(derivation)
    yield from _in_balances(derivation)
    for explanation in derivation.explanations:
        for paragraph in explanation.paragraphs:
            for equation in paragraph.equations:
                yield from symbols(equation.left) | symbols(equation.right)
        yield from _of_definitions(explanation.where)
    # Formulas of the user's own share what they rest on: each is looked at once.
    shared = {id(d.formula): d for result in derivation.results for d in result.where}
    yield from symbols(*(result.formula for result in derivation.results))
    yield from _of_definitions(shared.values())


def _of_definitions(where: Iterable[Definition]) -> Iterator[str]:
    for definition in where:
        yield from symbols(definition.formula)
