"""Expectations against results: proved equal by algebra, or refuted by a pose.

Two formulas that are equal as rational functions of lengths and exp(iα) are proved so
exactly. Otherwise they are evaluated at the default pose and at random ones: the first
that tells them apart refutes the expectation, and where none does the finding says only
that they agree. A formula is compared with what is printed: a result with friction in the
case of the default pose. A number is compared with what code gives at its pose.
"""

import math
import random
from collections.abc import Sequence
from types import MappingProxyType
from typing import Literal, NamedTuple

from ..algebra.equality import equal
from ..diagnostics import Diagnostic, Report
from ..diagnostics import check as words
from ..formula.tree import Formula
from ..formula.walk import evaluate, symbols
from ..frozen import replace
from ..model.mechanism import Expect, Mechanism
from ..model.result import Definition, Result
from ..model.values import Chain, Values, completed, dependent
from ..units import UNITS
from .poses import complete, default_pose, random_poses

POSES = 12
"""Random poses beside the default one."""

CLOSE = 1e-9
"""Relative difference below which two formulas agree at a pose."""


class Finding(NamedTuple):
    """What an ``expect`` came to; figures and pose are those that decided it.

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
    named = {r.name: r for r in results}
    findings = tuple(
        _judge(e, _with_names_of(e, named[e.subject], definitions), mechanism)
        for e in mechanism.expects
    )
    for finding in findings:
        if remark := _remark(finding, mechanism):
            report.add(remark)
    return findings


def _with_names_of(expect: Expect, result: Result, definitions: Sequence[Definition]) -> Result:
    """Return a result that defines what an expectation mentions of the pose, too."""
    used, chosen = set(symbols(expect.value)), list[Definition]()
    for name, formula in reversed(definitions):
        if name in used:
            chosen.append(Definition(name, formula))
            used |= symbols(formula)
    where = dict.fromkeys((*chosen[::-1], *result.where))
    return replace(result, where=tuple(where)) if chosen else result


def _judge(expect: Expect, result: Result, mechanism: Mechanism) -> Finding:
    if _is_number(expect):
        return _compare_number(expect, result, mechanism)
    printed = result.printed()
    if not expect.at and _proved(expect.value, printed, mechanism):
        return Finding(expect, "proved")
    return _compare_formula(expect, printed, mechanism)


# ------------------------------------------------------------------------- numbers


def _is_number(expect: Expect) -> bool:
    """Tell a figure, which may be a whole number without a tolerance, from a formula."""
    return bool(expect.tolerance or (expect.at and not symbols(expect.value)))


def _compare_number(expect: Expect, result: Result, mechanism: Mechanism) -> Finding:
    given = {p.name: default_pose(mechanism).get(p.name) for p in mechanism.parameters}
    kept = {n: v for n, v in given.items() if v is not None and n not in dependent(mechanism)}
    values = completed(complete(mechanism, kept | _at(expect)), result.where)
    missing = sorted(symbols(result.formula) - values.keys())
    if missing:
        return Finding(expect, "undecided", missing=missing[0])
    found, expected = evaluate(result.formula, values), evaluate(expect.value, values)
    slack = float(expect.tolerance) * (1 + CLOSE) + abs(expected) * 1e-12
    outcome: Literal["agrees", "refuted"] = (
        "agrees" if abs(found - expected) <= slack else "refuted"
    )
    return Finding(expect, outcome, found, expected, _shown_at(expect, result, mechanism, values))


def _at(expect: Expect) -> dict[str, float]:
    return {name: evaluate(value, {}) for name, value in expect.at.items()}


# ------------------------------------------------------------------------ formulas


def _proved(value: Formula, result: Result, mechanism: Mechanism) -> bool:
    chain = Chain(dependent(mechanism))
    definitions = [*chain.definitions, *(d for d in result.where if d.name not in chain.names)]
    return equal(value, result.formula, definitions)


def _compare_formula(expect: Expect, result: Result, mechanism: Mechanism) -> Finding:
    finding = Finding(expect, "undecided", poses=0)
    for pose in (default_pose(mechanism), *random_poses(mechanism, POSES)):
        values = _everything(complete(mechanism, {**pose, **_at(expect)}), expect, result)
        found, expected = evaluate(result.formula, values), evaluate(expect.value, values)
        at = _shown_at(expect, result, mechanism, values)
        if _differ(found, expected):
            return Finding(expect, "refuted", found, expected, at)
        if math.isfinite(found):
            finding = Finding(expect, "agrees", found, expected, at, poses=finding.poses + 1)
    return finding


def _differ(found: float, expected: float) -> bool:
    if math.isnan(found) or math.isnan(expected):
        return math.isnan(found) != math.isnan(expected)
    return abs(found - expected) > CLOSE * max(abs(found), abs(expected), 1e-9)


def _everything(values: Values, expect: Expect, result: Result) -> Values:
    """Give what has no value (a load, a length by dimension only) one; the same in each run."""
    wanted = symbols(result.formula) | symbols(expect.value)
    wanted |= {s for d in result.where for s in symbols(d.formula)}
    inner = {d.name for d in result.where}
    chance = random.Random(2)
    made_up = {n: chance.uniform(0.5, 1.5) for n in sorted(wanted - inner - values.keys())}
    return completed({**values, **made_up}, result.where)


# ------------------------------------------------------------------------- wording


def _remark(finding: Finding, mechanism: Mechanism) -> Diagnostic | None:
    span, subject = finding.expect.span, finding.expect.subject
    match finding.outcome:
        case "refuted":
            units = {p.name: p.unit for p in mechanism.parameters}
            at = {name: in_unit(value, units.get(name, "")) for name, value in finding.at.items()}
            found, expected = _figures(finding)
            return words.expectation_refuted(span, subject, found, expected, at)
        case "undecided" if finding.missing:
            return words.expectation_without_pose(span, subject, finding.missing)
        case "agrees" | "undecided" if not _is_number(finding.expect):
            return words.expectation_unproved(span, subject, finding.poses)
    return None


def _figures(finding: Finding) -> tuple[str, str]:
    """Return both numbers with as many digits as it takes to tell them apart."""
    for digits in range(6, 17):
        found, expected = f"{finding.found:.{digits}g}", f"{finding.expected:.{digits}g}"
        if found != expected:
            break
    if finding.expect.stated:
        return found, f"{expected} ± {float(finding.expect.tolerance):.6g}"
    return found, expected


def _shown_at(expect: Expect, result: Result, mechanism: Mechanism, values: Values) -> Values:
    """Return the values that either formula depends on, in declared order."""
    wanted = symbols(expect.value) | symbols(result.formula) | expect.at.keys()
    wanted |= {s for d in result.where for s in symbols(d.formula)}
    declared = [p.name for p in mechanism.parameters if p.name in wanted and not p.dependent]
    return {name: values[name] for name in declared if name in values}


def in_unit(value: float, unit: str) -> str:
    """Return an SI value in the unit that the user wrote.

    >>> in_unit(0.1, "mm"), in_unit(math.pi / 15, "deg"), in_unit(0.5, "")
    ('100 mm', '12 deg', '0.5')
    """
    if unit not in UNITS:
        return f"{value:.10g}"
    factor, _, pi = UNITS[unit]
    return f"{value / float(factor) / (math.pi if pi else 1):.10g} {unit}"
