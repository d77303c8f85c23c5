"""Sines and cosines of an angle in pairs, which many poses take at once."""

from collections.abc import Iterable, Iterator, Mapping, Sequence

from ...base.frozen import frozen
from ...base.named import NamedTuple
from ...formula.tree import Call, Formula, Power, Product, Sum, Symbol, is_call
from ...formula.walk import children, rebuild, symbols
from ...routine.steps import ProgramStatement, Step, formulas_of, names_of

PAIR = "_cos_sin"
"""The module's function that gives both."""

Circular = Mapping[Call, str]
"""The variables of sines and cosines."""


@frozen
class CosineAndSine:
    """``cosine, sine = _cos_sin(angle)``; a name is ``_`` where nothing mentions it."""

    cosine: str
    sine: str
    angle: Formula


class InPairs(NamedTuple):
    """Statements behind the pairs that they mention, formulas in these terms, and new names."""

    statements: list[ProgramStatement | CosineAndSine]
    formulas: list[Formula]
    names: list[str]


def in_pairs(
    statements: Sequence[ProgramStatement], formulas: Iterable[Formula], inputs: Iterable[str]
) -> InPairs:
    """Return statements and formulas that take sines and cosines of inputs from pairs.

    A statement that is only a sine or a cosine gives its name to it. What a solver computes,
    and the angles themselves, stay as they are.
    """
    ends, own = list(formulas), list(inputs)
    given = {name for s in statements for name in names_of(s)}
    found = _named(statements, ends, _varying(statements, own), {*own, *given})
    lines: list[ProgramStatement | CosineAndSine] = []
    paired = set[Formula]()
    for statement in statements:
        lines += _new_pairs(formulas_of(statement), found, paired)
        lines += _rewritten(statement, found)
    lines += _new_pairs(ends, found, paired)
    return InPairs(
        lines,
        [_taken(end, found) for end in ends],
        [name for name in found.values() if name not in given],
    )


def _new_pairs(
    formulas: Iterable[Formula], found: Circular, paired: set[Formula]
) -> Iterator[CosineAndSine]:
    """Yield the pair of each angle that formulas mention and that has none; note the angle."""
    for call in (call for formula in formulas for call in _calls(formula) if call in found):
        (angle,) = call.arguments
        if angle not in paired:
            paired.add(angle)
            cosine, sine = (found.get(Call(f, (angle,)), "_") for f in ("cos", "sin"))
            yield CosineAndSine(cosine, sine, angle)


def _rewritten(statement: ProgramStatement, found: Circular) -> Iterator[ProgramStatement]:
    """Yield a statement in variables; none of one that only names a sine or a cosine."""
    if not isinstance(statement, Step):
        yield statement
    elif not _is_named(statement, found):
        yield Step(statement.name, _taken(statement.formula, found))


def _varying(statements: Iterable[ProgramStatement], inputs: Iterable[str]) -> set[str]:
    """Return the names whose values rest on inputs."""
    found = set(inputs)
    for statement in statements:
        if any(not found.isdisjoint(symbols(f)) for f in formulas_of(statement)):
            found.update(names_of(statement))
    return found


def _named(
    statements: Iterable[ProgramStatement],
    ends: Iterable[Formula],
    varying: set[str],
    taken: set[str],
) -> dict[Call, str]:
    """Return the variable of each sine and cosine of what varies."""
    found: dict[Call, str] = {}
    calls = dict.fromkeys(
        call
        for formula in (*(f for s in statements for f in formulas_of(s)), *ends)
        for call in _calls(formula)
        if not varying.isdisjoint(symbols(call))
    )
    for s in statements:
        if isinstance(s, Step) and isinstance(s.formula, Call) and s.formula in calls:
            found.setdefault(s.formula, s.name)
    for number, call in enumerate(calls, 1):
        if call not in found:
            found[call] = _free(call, number, taken)
            taken.add(found[call])
    return found


def _free(call: Call, number: int, taken: set[str]) -> str:
    (angle,) = call.arguments
    name = f"{call.function}_{angle.name if isinstance(angle, Symbol) else number}"
    while name in taken:
        name += "_"
    return name


def _is_named(step: Step, found: Circular) -> bool:
    """Return whether a step is where a sine or a cosine gets its name."""
    formula = step.formula
    return isinstance(formula, Call) and found.get(formula) == step.name


def _calls(formula: Formula) -> Iterator[Call]:
    """Yield the sines and cosines of a formula, but not those in the angle of another."""
    if is_call(formula, "sin", "cos"):
        yield formula
    else:
        for part in children(formula):
            yield from _calls(part)


def _taken(formula: Formula, found: Circular) -> Formula:
    """Return a formula that takes sines and cosines from variables."""
    if isinstance(formula, Call) and formula in found:
        return Symbol(found[formula])
    parts = children(formula)
    taken = tuple(_taken(part, found) for part in parts)
    return formula if taken == parts else _as_it_stands(formula, taken)


def _as_it_stands(formula: Formula, parts: tuple[Formula, ...]) -> Formula:
    """Return a formula of other parts: in the same order, so that it is rounded alike."""
    match formula:
        case Sum():
            return Sum(parts)
        case Product():
            return Product(parts)
        case Power():
            return Power(*parts)
        case _:
            return rebuild(formula, parts)
