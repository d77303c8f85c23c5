"""Expectations against results: proved equal by algebra, or refuted by a pose.

Two formulas that are equal as rational functions of lengths and exp(iα) are proved so
exactly. Otherwise they are evaluated at the default pose and at random ones that can be
assembled: the first that separates them, by more than rounding does, refutes the
expectation, and where none does the finding says only that they agree. A formula is
compared with what is printed: a result with friction in the case of the default pose. A
number is compared with what code gives at its pose.
"""

import math
import random
from collections.abc import Iterable, Iterator, Sequence
from itertools import islice
from types import MappingProxyType
from typing import Literal

from ..algebra.equality import equal
from ..base.frozen import replace
from ..base.named import NamedTuple
from ..diagnostics import Diagnostic, Report
from ..diagnostics import expectations as messages
from ..formula.evaluate import evaluate
from ..formula.numeric.rounding import Rounded, Rounding
from ..formula.tree import Formula
from ..formula.walk import symbols
from ..model.mechanism import Expect, Mechanism
from ..model.result import Definition, Result
from ..model.values import (
    Chain,
    Values,
    allowed,
    bounds,
    complete,
    completed,
    default_pose,
    dependent,
    following,
    independent,
    user_defined,
    valid_form,
)
from ..units import in_unit, si_unit
from .analysis import as_printed
from .tolerances import SAME_FACTOR, SAME_FIGURE, SAME_RATIO
from .variables import scale_of

RANDOM_POSES = 12
"""Random poses in addition to the default one."""

ASSEMBLED_DRAWS = 60
"""How many are drawn, at most, to find so many that can be assembled."""

NARROW_DRAWS = 200
"""Draws before a narrow ``require`` is given up."""

ROUNDINGS = 4
"""How many times the rounding of both values a difference may have: it is a first-order bound."""


class Finding(NamedTuple):
    """The outcome of an ``expect``; figures and pose are those that decided it.

    ``missing`` is the parameter without a value, ``poses`` the number of poses compared at.
    """

    expect: Expect
    outcome: Literal["proved", "agrees", "refuted", "undecided"]
    found: float = math.nan
    expected: float = math.nan
    at: Values = MappingProxyType({})
    missing: str = ""
    poses: int = 1


def compare(
    mechanism: Mechanism,
    results: tuple[Result, ...],
    report: Report,
    definitions: Sequence[Definition] = (),
) -> tuple[Finding, ...]:
    """Return a finding for every ``expect``, and report those that are not proved.

    E581 where one is refuted, E582 where a number has no pose to be compared at, W581
    where formulas agree without a proof. ``definitions`` are those of the pose.
    """
    named, known = {r.name: r for r in results}, (*definitions, *_of_lets(results))
    findings = tuple(
        _finding(e, _with_names_of(e, named[e.subject], known), mechanism, definitions)
        for e in mechanism.expects
    )
    for finding in findings:
        unit = scale_of(named[finding.expect.subject], mechanism)
        if remark := _remark(finding, mechanism, unit):
            report.add(remark)
    return findings


def _of_lets(results: Iterable[Result]) -> Iterator[Definition]:
    """Yield the user's own formulas, each after those that it uses."""
    for result in results:
        if result.target is None:
            yield from result.where
            yield Definition(result.name, result.formula)


def _with_names_of(expect: Expect, result: Result, definitions: Sequence[Definition]) -> Result:
    """Return a result that defines what an expectation mentions of pose and lets, too."""
    used, chosen = set(symbols(expect.value)), list[Definition]()
    own = {d.name for d in result.where} | {result.name}
    for name, formula in reversed(definitions):
        if name in used - own:
            chosen.append(Definition(name, formula))
            used |= symbols(formula)
    where = dict.fromkeys((*chosen[::-1], *result.where))
    return replace(result, where=tuple(where)) if chosen else result


def _finding(
    expect: Expect, result: Result, mechanism: Mechanism, definitions: Sequence[Definition]
) -> Finding:
    if _is_number(expect):
        return _compare_number(expect, result, mechanism)
    printed = as_printed(result)
    if not expect.at and _proved(expect.value, printed, mechanism):
        return Finding(expect, "proved")
    return _compare_formula(expect, printed, mechanism, definitions)


# ------------------------------------------------------------------------- numbers


def _is_number(expect: Expect) -> bool:
    """Return whether a figure is expected, maybe a whole number without a tolerance, no formula."""
    return bool(expect.tolerance or (expect.at and not symbols(expect.value)))


def _compare_number(expect: Expect, result: Result, mechanism: Mechanism) -> Finding:
    """Return whether a figure of a book agrees with a result, to its last digit and to rounding."""
    given = {p.name: default_pose(mechanism).get(p.name) for p in mechanism.parameters}
    kept = {n: v for n, v in given.items() if v is not None and n not in dependent(mechanism)}
    pose = complete(mechanism, kept | _at(expect))
    values = completed(pose, result.where)
    missing = sorted(symbols(result.formula) - values.keys())
    if missing:
        return Finding(expect, "undecided", missing=missing[0])
    (found, error), (expected, other) = (
        _in_code(result, pose, mechanism),
        Rounding(values).of(expect.value),
    )
    slack = float(expect.tolerance) * (1 + SAME_RATIO) + abs(expected) * SAME_FIGURE
    slack += ROUNDINGS * (error + other)
    outcome: Literal["agrees", "refuted"] = (
        "agrees" if math.isfinite(found) and abs(found - expected) <= slack else "refuted"
    )
    return Finding(expect, outcome, found, expected, _shown_at(expect, result, mechanism, values))


def _in_code(result: Result, pose: Values, mechanism: Mechanism) -> Rounded:
    """Return the value in code at a pose: NaN where a condition of use or of the result fails."""
    known = Chain(user_defined(mechanism)).complete(pose)
    requires = tuple(
        r for r in mechanism.requires if r.concerns({result.name, *(d.name for d in result.where)})
    )
    sound = allowed(replace(mechanism, requires=requires), known)
    form = valid_form(result, pose) if sound else None
    if form is None:
        return Rounded(math.nan, 0.0)
    return Rounding(completed(pose, form.where)).of(form.formula)


def _at(expect: Expect) -> dict[str, float]:
    return {name: evaluate(value, {}) for name, value in expect.at.items()}


# ------------------------------------------------------------------------ formulas


def _proved(value: Formula, result: Result, mechanism: Mechanism) -> bool:
    chain = following(mechanism)
    definitions = [*chain.definitions, *(d for d in result.where if d.name not in chain.names)]
    return equal(value, result.formula, definitions)


def _compare_formula(
    expect: Expect, result: Result, mechanism: Mechanism, definitions: Sequence[Definition]
) -> Finding:
    """Return how a result compares with the formula expected, at the default pose and others."""
    finding = Finding(expect, "undecided", poses=0)
    drawn = (default_pose(mechanism), *random_poses(mechanism, ASSEMBLED_DRAWS))
    everything = (
        _everything(complete(mechanism, {**pose, **_at(expect)}), expect, result) for pose in drawn
    )
    assembled = (values for values in everything if _is_assembled(values, definitions))
    for given in islice(assembled, RANDOM_POSES + 1):
        rounding = Rounding(given)
        rounding.define(result.where)
        found, expected = rounding.of(result.formula), rounding.of(expect.value)
        at = _shown_at(expect, result, mechanism, given)
        if _differ(found, expected):
            return Finding(expect, "refuted", found.value, expected.value, at)
        if math.isfinite(found.value):
            poses = finding.poses + 1
            finding = Finding(expect, "agrees", found.value, expected.value, at, poses=poses)
    return finding


def _is_assembled(values: Values, definitions: Sequence[Definition]) -> bool:
    """Return whether there is a pose: nothing can be compared where a loop does not close."""
    found = completed(values, definitions)
    return not any(math.isnan(found.get(name, 0.0)) for name, _ in definitions)


def _differ(found: Rounded, expected: Rounded) -> bool:
    """Return whether two values differ by more than a relative part, and by more than rounding."""
    if math.isinf(found.error) or math.isinf(expected.error):
        return False
    if math.isnan(found.value) or math.isnan(expected.value):
        return math.isnan(found.value) != math.isnan(expected.value)
    slack = SAME_RATIO * max(abs(found.value), abs(expected.value))
    return abs(found.value - expected.value) > slack + ROUNDINGS * (found.error + expected.error)


def _everything(values: Values, expect: Expect, result: Result) -> Values:
    """Return values with one for what has none, such as a load; the same in each run."""
    wanted = symbols(result.formula) | symbols(expect.value)
    wanted |= {s for d in result.where for s in symbols(d.formula)}
    inner = {d.name for d in result.where}
    chance = random.Random(2)
    made_up = {n: chance.uniform(0.5, 1.5) for n in sorted(wanted - inner - values.keys())}
    return {**values, **made_up}


def random_poses(mechanism: Mechanism, number: int, seed: int = 1) -> Iterator[Values]:
    """Yield up to ``number`` poses that every ``require`` allows."""
    chance, chain = random.Random(seed), following(mechanism)
    drawn = (chain.complete(_draw(mechanism, chance)) for _ in range(NARROW_DRAWS))
    return islice((v for v in drawn if allowed(mechanism, v)), number)


def _draw(mechanism: Mechanism, chance: random.Random) -> Values:
    return {p.name: chance.uniform(*bounds(p)) for p in independent(mechanism)}


# ------------------------------------------------------------------------- wording


def _remark(finding: Finding, mechanism: Mechanism, unit: str) -> Diagnostic | None:
    """Return the error or warning at an expectation that is not proved; None at one that agrees."""
    span, subject = finding.expect.span, finding.expect.subject
    match finding.outcome:
        case "refuted":
            at = _in_units(finding.at, mechanism)
            found, expected = _figures(finding, unit)
            slip = _slip(finding) or likely_a_formula(finding, default_pose(mechanism))
            load = _open_load(finding, mechanism)
            return messages.expectation_refuted(span, subject, found, expected, at, slip, load)
        case "undecided" if finding.missing:
            return messages.expectation_without_pose(span, subject, finding.missing)
        case "agrees" | "undecided" if not _is_number(finding.expect):
            is_number = not symbols(finding.expect.value)
            return messages.expectation_unproved(span, subject, finding.poses, is_number)
    return None


def _open_load(finding: Finding, mechanism: Mechanism) -> str:
    """Return the first load without a value that a result with an expected figure rests on."""
    given = {let.name for let in mechanism.lets} | finding.expect.at.keys()
    is_open = (k.name for k in mechanism.loads if k.tie is None and k.name not in given)
    is_figure = not symbols(finding.expect.value) and finding.expected != 0
    return next((name for name in is_open if is_figure and name in finding.at), "")


def _figures(finding: Finding, unit: str) -> tuple[str, str]:
    """Return both numbers with as many digits as it takes to see the difference."""
    for digits in range(6, 17):
        found, expected = (in_unit(v, unit, digits) for v in (finding.found, finding.expected))
        if found != expected:
            break
    if finding.expect.stated:
        return found, f"{expected} ± {in_unit(float(finding.expect.tolerance), unit, 6)}"
    return found, expected


def likely_a_formula(finding: Finding, given: Values) -> "messages.LikelySlip":
    """Return that a figure was compared as a formula, and refuted at other values than given."""
    expect = finding.expect
    is_figure = not expect.at and not symbols(expect.value)
    elsewhere = any(given.get(name, value) != value for name, value in finding.at.items())
    return "figure" if is_figure and elsewhere else ""


def _slip(finding: Finding) -> "messages.LikelySlip":
    """Return the likely slip between two numbers, where it shows in them."""
    if not finding.expected or not math.isfinite(finding.found) or not finding.found:
        return ""
    times = abs(finding.found / finding.expected)
    if math.isclose(times, 1, rel_tol=SAME_FACTOR):
        return "sign" if finding.found * finding.expected < 0 else ""
    if math.isclose(abs(finding.found * finding.expected), 1, rel_tol=SAME_FACTOR):
        return "inverse"
    if any(math.isclose(times, factor, rel_tol=SAME_FACTOR) for factor in (2, 0.5)):
        return "twice"
    tens = math.log10(times)
    if round(tens) and math.isclose(times, 10.0 ** round(tens), rel_tol=SAME_FACTOR):
        return "unit"
    turned = (times, 1 / times)
    return (
        "degrees"
        if any(math.isclose(t, math.degrees(1), rel_tol=SAME_FACTOR) for t in turned)
        else ""
    )


def _shown_at(expect: Expect, result: Result, mechanism: Mechanism, values: Values) -> Values:
    """Return the values that either formula depends on, in declared order."""
    wanted = symbols(expect.value) | symbols(result.formula) | expect.at.keys()
    wanted |= {s for d in result.where for s in symbols(d.formula)}
    declared = [p.name for p in mechanism.parameters if not p.dependent]
    declared += [load.name for load in mechanism.loads]
    return {name: values[name] for name in declared if name in wanted and name in values}


def _in_units(at: Values, mechanism: Mechanism) -> dict[str, str]:
    """Return values as text: of parameters in the units written, of loads in those of the SI."""
    units = {p.name: p.unit for p in mechanism.parameters}
    units |= {load.name: si_unit(load.dimension) for load in mechanism.loads}
    return {name: in_unit(value, units.get(name, ""), 10) for name, value in at.items()}
