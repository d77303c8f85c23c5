"""Everything that can refute what is said of a mechanism, by what it looks at.

Each yields what is false, in words; nothing where all holds, or where it does not apply.
"""

import re
from collections.abc import Callable, Iterator
from contextlib import suppress
from math import isclose
from random import Random

import numpy as np

import branchings
import conclusions
import extents
import free_bodies_shown
import friction_statements
import plotted_marks
import reference_kinematics
import reference_strokes
import statements
import stroke_curves
import stroke_statements
from compiled_ratios import in_c, library
from homogeneous import uneven
from hunted import Hunted
from mechc.compilation import Compilation
from mechc.diagnostics import MechcError
from mechc.emit.c.real import REALS
from mechc.emit.latex.to_latex import TARGET as LATEX
from mechc.emit.registry import targets
from mechc.emit.target import Options
from mechc.model.parts.targets import LoadRatio, SpeedRatio, WithFriction
from mechc.plot.query import Query, usual
from mechc.report.text.derivation import render, render_brief
from mechc.routine.evaluate import status
from mechc.source import Source
from mechc.syntax import ast
from mechc.syntax.vocabulary import LANGUAGES, METHODS
from mechc.units import UNITS
from page import Page
from printed_units import PrintedUnits, displaced
from run_targets import (
    COMPILER,
    POSES,
    assert_close,
    by_c_in_batch,
    by_c_singly,
    by_interpreter,
    by_python,
)
from run_targets import poses as drawn

BEYOND = (ast.Actuator, ast.Spring, ast.Drawn, ast.Use, ast.Table, ast.Sizes)
"""What the reference of given poses does not read."""

TURNED = 1e-6
"""What results may differ by where sums are rounded in another order."""


def free_bodies(found: Hunted) -> Iterator[str]:
    """The second opinion; a result that it could not look at is no finding."""
    if not found.compilation.verdict.agrees:
        yield "the free bodies do not agree"


def limits(found: Hunted) -> Iterator[str]:
    """Trends, zeros and poles, proportions, what may be exchanged and what has no influence."""
    for result in found.compilation.results:
        yield from statements.refuted(found.compilation.pose.mechanism, result, found.seed)


def left_out(found: Hunted) -> Iterator[str]:
    """Zeros and poles of ratios without friction that are not stated."""
    for result in found.compilation.results:
        if isinstance(result.target, LoadRatio | SpeedRatio):
            yield from statements.missing(found.compilation.pose.mechanism, result, found.seed)


def causes(found: Hunted) -> Iterator[str]:
    """Slopes, dead centres and loads across the motion, what is infinite."""
    mechanism = found.compilation.pose.mechanism
    tree = None if found.is_closed else found.tree
    for result in found.compilation.results:
        yield from conclusions.refuted(tree, mechanism, result, found.seed)


def friction(found: Hunted) -> Iterator[str]:
    """Locking, jams, what an efficiency runs through, and the case that is printed."""
    return friction_statements.refuted(found.compilation)


def ranges(found: Hunted) -> Iterator[str]:
    """What ratios come to along the stroke and over ranges."""
    return extents.along(found.compilation)


def stroke(found: Hunted) -> Iterator[str]:
    """Ends of loops, singular poses, extrema, and friction along the stroke."""
    if found.stroke:
        yield from stroke_curves.refuted(found.compilation, found.stroke)
        yield from stroke_statements.refuted(found.compilation, found.stroke)
        yield from stroke_statements.zero_throughout(found.mechanism, found.stroke)
        yield from stroke_statements.moving(found.mechanism, found.stroke)


def branches(found: Hunted) -> Iterator[str]:
    """Poses in which a loop goes on in two ways, by the equations of the loop."""
    if found.flat and found.stroke:
        yield from branchings.refuted(found.flat, found.mechanism, found.stroke)


def motion(found: Hunted) -> Iterator[str]:
    """Results without friction, against the motion by singular values, or by places."""
    if found.grown:
        (function,) = (f for f in found.compilation.routine.functions if f.name == "k")
        yield from reference_strokes.refuted(found.grown, function)
    elif not found.is_closed and not any(isinstance(s, BEYOND) for s in found.tree.statements):
        yield from reference_kinematics.refuted(found.tree, found.compilation, found.seed)


def lengths(found: Hunted) -> Iterator[str]:
    """Formulas that do not balance in units."""
    return uneven(found.compilation)


def order(found: Hunted) -> Iterator[str]:
    """Results by default, where the same lines stand in another order.

    Of several drives the first one moves, so that theirs is none of words alone.
    """
    drives = [s for s in found.tree.statements if isinstance(s, ast.Drive)]
    if len(drives) > 1:
        return
    lines = [line for line in found.text.strip().splitlines() if line.strip()]
    head = [line for line in lines if line.startswith(("mechanism", "mechc"))]
    rest = [line for line in lines if line not in head]
    Random(f"order {found.seed}").shuffle(rest)
    yield from _others(found, "\n".join([*head, *rest]), "in another order of lines")


def names(found: Hunted) -> Iterator[str]:
    """Results by default, where parameters have other names.

    A name that is a unit as well, or one that a used mechanism has, is left as it is.
    """
    lines = found.tree.statements
    if any(isinstance(s, ast.Use) for s in lines):
        return
    given = {s.name.text for s in lines if isinstance(s, ast.Param)} - UNITS.keys()
    if not given:
        return
    order = sorted(given)
    Random(f"names {found.seed}").shuffle(order)
    other = {name: f"w{i}" for i, name in enumerate(order)}
    pattern = re.compile(rf"(?<![\w.'])({'|'.join(map(re.escape, order))})(?![\w'])")
    text = pattern.sub(lambda word: other[word[1]], found.text)
    yield from _others(found, text, "with other names of parameters")


def _others(found: Hunted, text: str, how: str) -> Iterator[str]:
    """Yield the results that have another value in a description that says the same."""
    other = Compilation(Source("other.mech", text, folder=found.folder)).solution
    values = {r.name: r.default for r in other.results}
    for result in found.compilation.solution.results:
        here, there = result.default, values.get(result.name)
        if not _is_same(here, there):
            yield f"{result.name} is {here}, {how} {there}"


def _is_same(here: float | None, there: float | None) -> bool:
    if here is None or there is None:
        return here is there
    return isclose(here, there, rel_tol=TURNED, abs_tol=TURNED)


def code(found: Hunted) -> Iterator[str]:
    """Emitted Python and C, which must give what the interpreter gives."""
    made, routine = found.compilation, found.compilation.routine
    expected = by_interpreter(made)
    assert_close(by_python(made), expected, 0, routine)
    if COMPILER:
        compiled = library(made)
        assert_close(by_c_singly(made, compiled), expected, 64, routine)
        assert_close(by_c_in_batch(made, compiled), expected, 64, routine)
        yield from statuses(made)


def statuses(made: Compilation) -> Iterator[str]:
    """Statuses in compiled C, on which more rests that is said of friction."""
    functions = {f.name: f for f in made.routine.functions}
    named = {r.target: r.name for r in made.results}
    call = in_c(made)
    for target, name in named.items():
        if call is None or not isinstance(target, WithFriction) or not functions[name].status:
            continue
        real, ideal = functions[name], functions[named[target.of]]
        values = {**drawn(real.status), **drawn(ideal), **drawn(real)}
        found = call(f"{name}_status_n", [i.name for i in real.status.inputs], np.intc, values)
        expected = np.broadcast_to(status(real, ideal, values), POSES)
        if not np.array_equal(np.broadcast_to(found, POSES), expected):
            yield f"the status of {name} is {found.tolist()} in C, {expected.tolist()} expected"


def page(found: Hunted) -> Iterator[str]:
    """Every formula of a report with its numbers and units, read back from LaTeX."""
    read = Page(found.compilation)
    yield from read.wrong()
    (document,) = LATEX.emit(found.compilation, Options("page"))
    units = PrintedUnits(document.text, read.printed())
    yield from units.contradictions()
    yield from units.unread
    yield from displaced(document.text)


def curves(found: Hunted) -> Iterator[str]:
    """Points that the plots of reports mark: values by default, extrema beyond the curve."""
    made = found.compilation
    if not (over := usual(made.pose.mechanism, made.routine)):
        return
    shown = (result for result in made.results if result.name in over.ys)
    for result in shown:
        with suppress(MechcError):  # more loads than have values, or no curve at all
            yield from plotted_marks.refuted(result, made.plot(Query(over.x, (result.name,))))


def sums(found: Hunted) -> Iterator[str]:
    """Every formula of a derivation by sums of forces and moments, with friction behind it."""
    with suppress(MechcError):  # where no sums lead to a load
        yield from Page(found.compilation, by="equilibrium").wrong()


def bodies(found: Hunted) -> Iterator[str]:
    """The free bodies that pictures show, with friction and without it."""
    return free_bodies_shown.refuted(found.compilation)


def outputs(found: Hunted) -> Iterator[str]:
    """All files and what the terminal shows, with options drawn at random: nothing may fail."""
    made, chance = found.compilation, Random(found.seed)
    for target in targets().values():
        with suppress(MechcError):  # what a target cannot say, it refuses
            target.emit(made, _options(chance))
    reported = made.by_equilibrium if found.seed % 2 else made.reported
    shown = chance.choice((render, render_brief))
    language = chance.choice(LANGUAGES)
    shown(reported, made.mechanism, unicode=True, numbers=True, language=language, width=80)
    return iter(())


def _options(chance: Random) -> Options:
    """Return options of reports and of code; both are given to every target."""
    yes = (False, True)
    return Options(
        "hunted",
        language=chance.choice(LANGUAGES),
        numbers=chance.choice(yes),
        brief=chance.choice(yes),
        pictures=chance.choice(yes),
        gradient=chance.choice(yes),
        c_real=chance.choice(sorted(REALS)),
        by=chance.choice(METHODS),
    )


REFUTERS: dict[str, Callable[[Hunted], Iterator[str]]] = {
    one.__name__.replace("_", " "): one
    for one in (
        free_bodies, limits, left_out, causes, friction, ranges, stroke, branches,
        motion, lengths, order, names, code, page, curves, sums, bodies, outputs,
    )
}  # fmt: skip
