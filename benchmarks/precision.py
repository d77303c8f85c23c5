"""Errors of emitted code in ulp, against the formulas of the derivation at 50 digits.

Poses along the stroke are well conditioned. The others lie ever closer to where the loop
ceases to close, with a link's length chosen so: the knee is straight there, and nothing
that follows from it is known better than κ times the last digit of the lengths. κ is
Σ|x·∂q/∂x|/|q|, by how much more a quantity changes than what it is computed from.
"""

import ctypes
import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import reduce
from pathlib import Path
from statistics import median
from tempfile import TemporaryDirectory
from typing import Any, NamedTuple, assert_never

import mpmath

from emitted import built, code, stroke
from measure import table
from mechc.compilation import Compilation, compile_source, emit
from mechc.emit import registry
from mechc.emit.target import Options
from mechc.files import library, read
from mechc.formula.derivative import jacobian
from mechc.formula.evaluate import evaluate, solution
from mechc.formula.tree import (
    Call,
    Constant,
    Formula,
    Implicit,
    Number,
    Pi,
    Power,
    Product,
    Sum,
    Symbol,
)

DIGITS = 50
Wide = Any
"""A number of mpmath, which has no types."""

KNEES = {
    "crank_rocker": "b",
    "claw_closed": "l",
    "oscillating_cylinder": "s",
    "whitworth": "l",
    "watt_closed": "b",
    "triad_closed": "phi",
}
"""Mechanisms, and what is changed until the loop just closes."""


class Errors(NamedTuple):
    """How far one quantity was off at each pose, in ulp, and how it was conditioned."""

    ulp: list[float]
    kappa: list[float]


# ---------------------------------------------------------------------- exact values


def exact(formula: Formula, known: Mapping[str, Wide]) -> Wide:
    """Return a formula's value in mpmath's numbers; complex where there is none."""
    match formula:
        case Number(value):
            return mpmath.mpf(value.numerator) / value.denominator
        case Pi():
            return +mpmath.pi
        case Constant(_, value):
            return exact(value, known)
        case Symbol(name):
            return known[name]
        case Sum(terms):
            return mpmath.fsum(exact(t, known) for t in terms)
        case Product(factors):
            return mpmath.fprod(exact(f, known) for f in factors)
        case Power(base, exponent):
            return mpmath.power(exact(base, known), exact(exponent, known))
        case Call("hypot", arguments):
            return reduce(mpmath.hypot, (exact(a, known) for a in arguments))
        case Call("abs", (argument,)):
            return abs(exact(argument, known))
        case Call(function, arguments):
            return getattr(mpmath, function)(*(exact(a, known) for a in arguments))
        case Implicit():
            return solved(formula, [exact(a, known) for a in formula.arguments])[formula.index]
        case _:
            assert_never(formula)


def solved(formula: Implicit, outer: Sequence[Wide]) -> Sequence[Wide]:
    """Return the unknowns of a system, from those in floats by Newton's method."""
    system = formula.system
    names = [name for name, _ in system.anchor]
    x = mpmath.matrix(solution(system, tuple(map(float, outer))))
    rows = jacobian(system.equations, system.unknowns)
    for _ in range(3):
        here = dict(zip((*system.unknowns, *names), (*x, *outer), strict=True))
        right = mpmath.matrix([exact(e, here) for e in system.equations])
        matrix = mpmath.matrix([[exact(e, here) for e in row] for row in rows])
        x -= mpmath.lu_solve(matrix, right)
    return list(x)


class Case(NamedTuple):
    """One mechanism: its values at the default pose, and what follows from values.

    ``codes`` return what emitted code makes of values, by name; empty where loops do not
    close. ``formulas`` are the same quantities for the reader, in order.
    """

    name: str
    values: dict[str, float]
    codes: tuple[Callable[[Mapping[str, float]], dict[str, float]], ...]
    formulas: tuple[tuple[str, Formula], ...]

    def exactly(self, values: Mapping[str, Wide]) -> dict[str, Wide]:
        """Return all quantities at values."""
        known = dict(values)
        for name, formula in self.formulas:
            known[name] = exact(formula, known)
        return {name: known[name] for name in self.quantities}

    def has_values(self, values: Mapping[str, float]) -> bool:
        """Tell whether the interpreter finds them all: at the very edge rounding decides."""
        known = dict(values)
        for name, formula in self.formulas:
            known[name] = evaluate(formula, known)
        return all(map(math.isfinite, known.values()))

    @property
    def quantities(self) -> list[str]:
        """Return the names of what is computed, numbers of the description apart."""
        return [name for name, formula in self.formulas if not isinstance(formula, Number)]


def case(name: str) -> tuple[Case, Compilation]:
    """Return a mechanism of the library and its compilation."""
    compilation = compile_source(read(library()[name]))
    function, pose = compilation.routine.functions[0], compilation.routine.pose
    values = {i.name: i.default for i in (*function.inputs, *pose.inputs)}
    formulas = ((s.name, s.formula) for s in function.where)
    shown = (*formulas, (function.name, function.formula))
    return Case(name, values, (_python(compilation),), shown), compilation


def _python(compilation: Compilation) -> Callable[[Mapping[str, float]], dict[str, float]]:
    function, pose = compilation.routine.functions[0], compilation.routine.pose
    (file,) = emit(compilation, registry.load("python"), Options("k", single=True))
    space: dict[str, Any] = {}
    exec(file.text, space)

    def run(values: Mapping[str, float]) -> dict[str, float]:
        found, status = space["pose"](*(values[i.name] for i in pose.inputs))
        k = space[function.name](*(values[i.name] for i in function.inputs))
        return {} if status else {**found, function.name: k}

    return run


def _c(compilation: Compilation) -> Callable[[Mapping[str, float]], dict[str, float]]:
    function, pose = compilation.routine.functions[0], compilation.routine.pose
    with TemporaryDirectory() as folder:
        source = Path(folder) / "own.c"
        source.write_text(code(compilation), encoding="utf-8")
        own = built([source])
    stem = compilation.routine.name
    posed, result = getattr(own, f"{stem}_pose"), getattr(own, f"{stem}_{function.name}")
    result.restype = ctypes.c_double

    def run(values: Mapping[str, float]) -> dict[str, float]:
        found = {name: ctypes.c_double() for name in pose.outputs}
        given = (ctypes.c_double(values[i.name]) for i in pose.inputs)
        status = posed(*given, *map(ctypes.byref, found.values()))
        k = result(*(ctypes.c_double(values[i.name]) for i in function.inputs))
        return {} if status else {n: v.value for n, v in found.items()} | {function.name: k}

    return run


# ----------------------------------------------------------------------------- poses


def towards_the_knee(case: Case, name: str, number: int) -> Iterator[dict[str, float]]:
    """Yield values ever closer to where the loop ceases to close, to 1e-12 of the value."""
    inside, outside = _edge(case, name)
    for i in range(number):
        distance = 10 ** -(2 + 10 * i / (number - 1))
        yield case.values | {name: outside + math.copysign(distance * outside, inside - outside)}


def _edge(case: Case, name: str) -> tuple[float, float]:
    """Return two neighbouring values, between which the loop ceases to close."""
    start = case.values[name]

    def closed(value: float) -> bool:
        known = case.values | {name: value}
        return bool(case.codes[0](known)) and case.has_values(known)

    away = (start * (1 + sign * i / 64) for i in range(1, 128) for sign in (-1, 1))
    inside, outside = start, next(value for value in away if not closed(value))
    while (middle := (inside + outside) / 2) not in (inside, outside):
        inside, outside = (middle, outside) if closed(middle) else (inside, middle)
    return inside, outside


# ---------------------------------------------------------------------------- errors


def errors(case: Case, poses: Iterable[Mapping[str, float]]) -> dict[str, Errors]:
    """Return how far code was off at poses, the worst of all languages at each."""
    found = {name: Errors([], []) for name in case.quantities}
    with mpmath.workdps(DIGITS):
        for values in poses:
            computed = [code(values) for code in case.codes]
            if not all(computed):
                continue
            wide = {n: mpmath.mpf(v) for n, v in values.items()}
            for name, value in case.exactly(wide).items():
                off = max(abs(c[name] - value) for c in computed)
                found[name].ulp.append(float(off / math.ulp(float(value))))
            for name, kappa in _conditions(case, wide).items():
                found[name].kappa.append(kappa)
    return found


def _conditions(case: Case, values: Mapping[str, Wide]) -> dict[str, float]:
    """Return Σ|x·∂q/∂x|/|q| of every quantity, by differences."""
    step = mpmath.mpf(10) ** -(DIGITS // 2)
    here = case.exactly(values)
    total = dict.fromkeys(here, mpmath.mpf(0))
    for name, value in values.items():
        moved = case.exactly({**values, name: value * (1 + step)})
        for q in here:
            total[q] += abs((moved[q] - here[q]) / (step * here[q]))
    return {q: float(kappa) for q, kappa in total.items()}


def precision(poses: int) -> None:
    """Print median and worst errors, along the stroke and near a straight knee."""
    rows = [row for name, knee in KNEES.items() for row in _rows(name, knee, poses)]
    heading = ("quantity", *("κ", "median", "worst", "worst/κ") * 2)
    title = "Errors in ulp: along the stroke (κ is the largest), then towards a straight knee"
    table(title, heading, rows)


def _rows(name: str, knee: str, poses: int) -> Iterator[tuple[object, ...]]:
    plain, compilation = case(name)
    both = plain._replace(codes=(*plain.codes, _c(compilation)))
    drive = compilation.mechanism.drive.parameter
    usual = errors(both, ({**both.values, drive: float(v)} for v in stroke(compilation, poses)))
    near = errors(both, towards_the_knee(both, knee, poses))
    for quantity in usual:
        yield (f"{name}: {quantity}", *_summary(usual[quantity]), *_summary(near[quantity]))


def _summary(found: Errors) -> tuple[float, ...]:
    worst = max(u / max(k, 1.0) for u, k in zip(found.ulp, found.kappa, strict=True))
    return max(found.kappa), median(found.ulp), max(found.ulp), worst
