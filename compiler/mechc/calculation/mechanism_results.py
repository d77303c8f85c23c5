"""Results that a sheet takes from mechanisms, with what the sheet gives to these.

:func:`solved` is a mechanism by its own names,
:func:`resting_on_sheet` its results as those of the sheet.
"""

from collections.abc import Iterator, Mapping

from ..base.frozen import replace
from ..base.named import NamedTuple
from ..formula.evaluate import evaluate
from ..formula.numeric.rounding import Rounding, beyond_rounding
from ..formula.tree import Formula
from ..formula.walk import symbols
from ..friction import at_rest
from ..model.mechanism import Mechanism, Parameter, Require, Subject
from ..model.result import Definition, FrictionResult, Result, UsedSolution
from ..model.values import Values, completed, holds, ordered, user_defined, valid_form
from ..pose.pose import Pose
from ..units import ANGLE


def solved(pose: Pose, results: tuple[Result, ...]) -> UsedSolution:
    """Return the results, definitions and conditions of a mechanism, by its own names.

    Angles and lengths that no line gives but the drawing are numbers with names.
    """
    definitions = {d.name: Definition(*d) for d in pose.definitions}
    drawn = tuple(_drawn(pose))
    more = (Definition(d.name, d.value) for d in drawn if d.value and d.name not in definitions)
    return UsedSolution(
        results,
        (*definitions.values(), *more),
        pose.loops,
        tuple(_of_the_pose(pose)),
        (*pose.mechanism.literals, *drawn),
    )


def _drawn(pose: Pose) -> Iterator[Parameter]:
    """Yield the angles and lengths of links that the drawing gives, and nothing drives."""
    for parameter in pose.mechanism.parameters:
        made_up = parameter.dependent and parameter.name.startswith(("phi_", "len_"))
        if made_up and parameter.value and not symbols(parameter.value):
            yield parameter


def _of_the_pose(pose: Pose) -> Iterator[Require]:
    """Yield the conditions on what is found by loops, which the sheet has no names for."""
    defined = {d.name for d in pose.definitions}
    for require in pose.mechanism.requires:
        if defined & (symbols(require.left) | symbols(require.right)):
            unit = "deg" if require.dimension == ANGLE else ""
            yield replace(require, subject=Subject("pose", "", ""), unit=unit)


class _Whole(NamedTuple):
    """A name with all that it rests on, as it is and elsewhere, and the conditions of that."""

    here: Mapping[str, Formula]
    elsewhere: Mapping[str, Formula]
    guards: tuple[Require, ...]
    has_other: bool


def resting_on_sheet(mechanism: Mechanism, solved: UsedSolution) -> tuple[Result, ...]:
    """Return the results of used mechanisms, each resting on parameters of the sheet alone.

    What the sheet gives to a mechanism stands among the definitions of its results.
    """
    lets = user_defined(mechanism)
    results = {result.name: result for result in solved.results}
    needs = {name: set(symbols(value)) for name, value in lets.items()}
    needs |= {name: set(_symbols(result)) for name, result in results.items()}
    known = needs.keys()
    order, _ = ordered({name: (used & known) - {name} for name, used in needs.items()})
    wholes: dict[str, _Whole] = {}
    found: dict[str, Result] = {}
    for name in order:
        before = _union([wholes[n] for n in sorted(needs[name] & wholes.keys())])
        if name in lets:
            wholes[name] = _with(before, name, lets[name], lets[name])
        else:
            found[name] = result = _resting_on(results[name], before)
            wholes[name] = _of(result)
    return tuple(found[name] for name in results)


def _union(parts: list[_Whole]) -> _Whole:
    """Return the definitions and conditions of several parts as those of one."""
    return _Whole(
        {n: f for part in parts for n, f in part.here.items()},
        {n: f for part in parts for n, f in part.elsewhere.items()},
        tuple(dict.fromkeys(g for part in parts for g in part.guards)),
        any(part.has_other for part in parts),
    )


def _with(before: _Whole, name: str, here: Formula, elsewhere: Formula) -> _Whole:
    return before._replace(
        here={**before.here, name: here}, elsewhere={**before.elsewhere, name: elsewhere}
    )


def _of(result: Result) -> _Whole:
    other = result.elsewhere or result
    here, there = dict(result.where), dict(other.where)
    whole = _Whole(here, there, result.guards, result.elsewhere is not None)
    return _with(whole, result.name, result.formula, other.formula)


def _resting_on(result: Result, before: _Whole) -> Result:
    """Return a result whose definitions begin with those that stand before it."""
    other = result.elsewhere or (result if before.has_other else None)
    found = _behind(result, before.here)
    guards = tuple(dict.fromkeys((*before.guards, *found.guards)))
    elsewhere = _behind(other, before.elsewhere) if other else None
    return replace(found, guards=guards, elsewhere=elsewhere)


def _behind(result: Result, before: Mapping[str, Formula]) -> Result:
    """Return a result with other definitions before its own."""
    given = tuple(Definition(*pair) for pair in before.items())
    found = replace(result, where=tuple(dict.fromkeys((*given, *result.where))))
    if isinstance(found, FrictionResult) and found.case:
        where = tuple(dict.fromkeys((*given, *found.case.where)))
        return replace(found, case=replace(found.case, where=where))
    return found


def _symbols(result: Result) -> frozenset[str]:
    """Return the names that a result mentions, wherever it does, but for those that it defines."""
    own = {d.name for d in result.where}
    parts = [result.formula, *(d.formula for d in result.where)]
    parts += [side for g in result.guards for side in (g.left, g.right)]
    names = frozenset[str]().union(*map(symbols, parts)) - own
    return names | _symbols(result.elsewhere) if result.elsewhere else names


def with_values(results: tuple[Result, ...], values: Values) -> Iterator[Result]:
    """Yield results with their values at those of the sheet, None where they have none.

    One with friction is printed for the signs that it has there.
    """
    for result in results:
        found = replace(result, default=_value(result, values))
        yield found if _is_in_its_case(found, values) else replace(found, case=None)


def _value(result: Result, values: Values) -> float | None:
    """Return the value of the form that stands there, 0 where that is all but for rounding.

    None where there is none.
    """
    form = valid_form(result, values)
    if form is None:
        return None
    known = completed(values, form.where)
    if not symbols(form.formula) <= known.keys():
        return None
    number = evaluate(form.formula, known)
    is_zero = beyond_rounding(number, form.formula, form.where, Rounding(values)).number == 0
    return 0.0 if is_zero else number


def is_at_rest(result: Result, values: Values) -> bool:
    """Return whether a slip is 0 at the values of a sheet, so that its friction has no sense."""
    form = valid_form(result, values)
    return form is not None and at_rest.slips_at_rest(form, values) > 0


def _is_in_its_case(result: Result, values: Values) -> bool:
    """Return whether the signs are those for which a result is printed, if it has any."""
    if not isinstance(result, FrictionResult) or result.case is None:
        return True
    signs = completed(values, result.case.where)
    return all(holds(condition, signs) for condition in result.case.holds)
