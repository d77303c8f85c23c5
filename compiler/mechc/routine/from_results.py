"""From results to straight-line programs, one function per ``find`` and ``let``."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import starmap
from typing import TYPE_CHECKING

from ..base.frozen import replace
from ..formula.evaluate import evaluate
from ..formula.tree import Formula, Implicit, Number, Symbol
from ..formula.walk import symbols
from ..model.dependence import unused
from ..model.mechanism import Load, Mechanism, Parameter, Require, WithFriction
from ..model.result import FrictionResult, Result
from ..model.statements import is_sheet
from ..pose.pose import ClosedLoop
from ..units import TORQUE, si_unit
from . import common_steps
from .companions import Companions
from .functions import AskedResult, asked, checks, functions
from .lengths import with_roots
from .scope import ProgramScope
from .sharing import share
from .steps import (
    Function,
    Input,
    PointsProgram,
    PoseProgram,
    Routine,
    formulas_of,
    leading_to,
    names_of,
)

if TYPE_CHECKING:
    from ..pose.motion import Motion

FEWEST_SHARED_DEFINITIONS = 24
"""Definitions beyond which functions may compute together what they have in common."""


def program(
    mechanism: Mechanism,
    results: tuple[Result, ...],
    definitions: Mapping[str, Formula] | None = None,
    loops: Sequence[ClosedLoop] = (),
    motion: "Motion | None" = None,
) -> Routine:
    """Return the routine that computes every result.

    Each function takes the parameters it depends on in declared order, then the loads
    it depends on, all in SI. A ``require`` guards those functions whose inputs decide
    it; one that needs more than a function is given is left to its caller. ``definitions``
    are those of the pose, on which conditions may rest that no result does; ``loops`` must
    close for a result to have a value, needed for it or not. ``motion`` is that of the drive.
    What a used mechanism gives and nothing in a sheet needs has no function.
    Raises ``LookupError`` for a name that neither the mechanism nor a result explains.
    """
    definitions, inputs = definitions or {}, _inputs(mechanism)
    scope = ProgramScope(mechanism, results, definitions)
    names = (*inputs, *scope.results)
    needed = _needed(mechanism, results)
    listed = [asked(r, scope, inputs, loops) for r in needed]
    found = _functions(listed, scope, names)
    changed = tuple(r.elsewhere or r for r in results)
    other = ProgramScope(mechanism, changed, definitions) if changed != results else scope
    forms = [asked(r.elsewhere, other, inputs, loops) for r in needed if r.elsewhere]
    elsewhere = _separate(forms, other, names)
    otherwise = (elsewhere.get(r.name) for r in needed)
    companions = Companions(scope, tuple(inputs.values()))
    joined = starmap(companions.joined, zip(found, otherwise, listed, strict=True))
    units = _units(mechanism)
    made = tuple(replace(each, units=_given(each, units)) for each in joined)
    tests = checks(scope, inputs, names) if is_sheet(mechanism) else None
    return Routine(
        name=mechanism.name,
        title=mechanism.title,
        source=mechanism.source,
        functions=made,
        pose=_pose(scope, inputs, loops),
        points=_points(mechanism, motion, inputs, definitions) if motion else None,
        checks=tests,
        unchecked=() if tests else _unchecked(mechanism, listed),
    )


def _unchecked(mechanism: Mechanism, listed: Iterable[AskedResult]) -> tuple[Require, ...]:
    """Return the conditions that no function checks."""
    checked = {id(r) for one in listed for r in one.requires}
    return tuple(r for r in mechanism.requires if id(r) not in checked)


def _units(mechanism: Mechanism) -> dict[str, str]:
    """Return the units of the SI of everything that a description may give by a number."""
    given = (*mechanism.parameters, *mechanism.literals, *mechanism.loads)
    return {each.name: si_unit(each.dimension) for each in given}


def _given(function: Function, units: Mapping[str, str]) -> dict[str, str]:
    """Return the units of what the formula of a function rests on and is a number."""
    numbers = (step.name for step in function.where if isinstance(step.formula, Number))
    return {name: units[name] for name in numbers if units.get(name)}


def _needed(mechanism: Mechanism, results: Sequence[Result]) -> list[Result]:
    """Return the results that have functions: of a used mechanism those that the sheet needs.

    So it is with what follows from them. The status of a ratio with friction asks for that
    without, too.
    """
    given = mechanism.follow | {known.name for known in mechanism.taken}
    aside = given.intersection(unused(mechanism, results) if given else ())
    own = (r for r in results if r.name not in aside)
    ideal = {r.target.of for r in own if isinstance(r.target, WithFriction)}
    return [r for r in results if r.name not in aside or r.target in ideal]


def _functions(
    listed: Sequence[AskedResult], scope: ProgramScope, names: Sequence[str]
) -> Iterator[Function]:
    """Yield the function of each result; many long ones share their steps."""
    long = [one for one in listed if len(one.result.where) > FEWEST_SHARED_DEFINITIONS]
    found = common_steps.with_common_steps(long, scope, names) if long else {}
    others = (one for one in listed if one.result.name not in found)
    found |= _separate(others, scope, names)
    return (found[one.result.name] for one in listed)


def _separate(
    listed: Iterable[AskedResult], scope: ProgramScope, names: Sequence[str]
) -> dict[str, Function]:
    """Return by name functions that compute all themselves; those with one system are one work.

    What drives, an efficiency and forces at joints follow from the same coupled equations.
    """
    groups: dict[frozenset[str], list[AskedResult]] = {}
    for one in listed:
        groups.setdefault(_unknowns(one.result) or frozenset({one.result.name}), []).append(one)
    return {f.name: f for group in groups.values() for f in functions(group, scope, names)}


def _unknowns(result: Result) -> frozenset[str]:
    """Return the unknowns of systems on which a result with friction rests."""
    where = result.where if isinstance(result, FrictionResult) else ()
    return frozenset(d.name for d in where if isinstance(d.formula, Implicit))


def _pose(
    scope: ProgramScope, inputs: Mapping[str, Input], loops: Sequence[ClosedLoop]
) -> PoseProgram | None:
    """Return the program of what closes loops, as far as results or conditions need it."""
    found = scope.intermediates()
    needed = {name for name, _ in found.formulas}
    unseen = [loop for loop in loops if loop.names.isdisjoint(needed)]
    if unseen:
        found = scope.intermediates(n for loop in unseen for n in sorted(loop.names))
    if not found.names:
        return None
    names = tuple(found.names)
    return _giving(names, names, found.formulas, inputs, scope.results)


def _points(
    mechanism: Mechanism,
    motion: "Motion",
    inputs: Mapping[str, Input],
    definitions: Mapping[str, Formula],
) -> PointsProgram:
    """Return the program of a motion."""
    quantities = motion.quantities
    own = {q.name: q.formula for q in quantities if not q.is_named}
    scope = ProgramScope(mechanism, (), {**definitions, **dict(motion.definitions), **own})
    names = tuple(q.name for q in quantities)
    found = scope.definitions("", map(Symbol, names))
    numbers = [q.formula for q in quantities if q.is_named]
    closed = tuple(q.name for q in quantities if q.kind == "place")
    return PointsProgram(_giving(names, closed, found.formulas, inputs, (), numbers), quantities)


def _giving(
    outputs: tuple[str, ...],
    closed: tuple[str, ...],
    formulas: Sequence[tuple[str, Formula]],
    inputs: Mapping[str, Input],
    taken: Iterable[str],
    numbers: Sequence[Formula] = (),
) -> PoseProgram:
    """Return the program that gives some of the names that formulas define, or of numbers."""
    names = {*inputs, *taken, *(name for name, _ in formulas)}
    rooted, _ = with_roots(formulas, [], names)
    shared, _ = share(rooted, numbers, [*inputs, *taken])
    steps = leading_to(outputs, shared)
    used = frozenset[str]().union(*(symbols(f) for step in steps for f in formulas_of(step)))
    defined = {name for step in steps for name in names_of(step)}
    used |= frozenset(outputs)
    known = tuple(item for name, item in inputs.items() if name in used - defined)
    return PoseProgram(known, steps, outputs, closed)


# -------------------------------------------------------------------------- inputs


def _inputs(mechanism: Mechanism) -> dict[str, Input]:
    """Return all that a function may take: free parameters, then loads, in declared order.

    Those of the description itself come before what is brought in, wherever a ``use`` stands: YAML
    has a place of its own for these lines.
    """
    own_first = sorted(mechanism.parameters, key=lambda p: p.name in mechanism.brought)
    free = [_parameter(p) for p in own_first if not p.dependent]
    loads = [_load(load) for load in mechanism.loads if load.tie is None]
    return {item.name: item for item in (*free, *loads)}


def _parameter(parameter: Parameter) -> Input:
    low, high = parameter.range or (None, None)
    return Input(
        name=parameter.name,
        dimension=parameter.dimension,
        unit=parameter.unit,
        default=_constant(parameter.value),
        low=_constant(low),
        high=_constant(high),
        label="; ".join(text for text in (parameter.label, parameter.about) if text),
        tolerance=_constant(parameter.tolerance),
    )


def _load(load: Load) -> Input:
    return Input(load.name, load.dimension, "N*m" if load.dimension == TORQUE else "N")


def _constant(formula: Formula | None) -> float | None:
    return None if formula is None else evaluate(formula, {})
