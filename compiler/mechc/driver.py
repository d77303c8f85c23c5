"""The compiler from text to emitted files: its stages, one line each.

A :class:`Compilation` holds every stage's value. Each is made when it is first asked
for, with those before it, so that ``fmt`` stops after syntax and ``show pose`` after
the pose. A stage that finds errors ends the compilation with :class:`MechcError`.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Concatenate, ParamSpec, TypeVar

from .diagnostics import Diagnostic, MechcError, Report
from .diagnostics import sheets as messages
from .emit.target import Emitted, Options, Target
from .files import resolved
from .friction.from_balance import solve
from .friction.solution import Solution
from .frozen import replace
from .kinematics.from_pose import plan_velocities
from .kinematics.plan import Plan
from .model.brought import Used
from .model.from_syntax import resolve
from .model.mechanism import Link, Mechanism
from .model.result import Definition, Result
from .model.sheets import is_sheet
from .model.uses import Composed, with_used
from .model.values import defaults, independent
from .pose.from_model import solve_pose
from .pose.pose import Pose
from .power.balance import Balance
from .power.from_plan import balance
from .routine.from_results import program
from .routine.steps import Routine
from .source import Source
from .stage import Stage, within
from .statics.referee import cross_check
from .statics.verdict import Verdict
from .study.analysis import as_printed
from .study.expectations import Finding, compare
from .study.stroke.gaps import remark as look_for_gaps
from .study.stroke.in_step import remark
from .syntax import ast
from .syntax.notation import read
from .syntax.settings import Setting, Settings, attached, driven_by, parse, put_in
from .units import in_unit, si_unit
from .version import VERSION
from .work import Allowance

if TYPE_CHECKING:
    from .calculation.calculation import Calculation
    from .drawing.drawing import Drawing
    from .drawing.moving import Marks
    from .equilibrium.equilibrium import Equilibrium
    from .figure.figure import Figure
    from .figure.velocities import Velocities
    from .plot.from_routine import Watch
    from .plot.plot import Plot
    from .plot.query import Query
    from .pose.motion import Motion
    from .report.derivation.steps import Derivation
    from .statics.diagram import Diagram
    from .study.analysis import Analysis
    from .study.stroke.stroke import Stroke

T = TypeVar("T")
P = ParamSpec("P")

STAGES: Mapping[str, str] = {
    "syntax": "composed",
    "model": "mechanism",
    "pose": "pose",
    "kinematics": "plan",
    "power": "balance",
    "friction": "solution",
    "calculation": "calculation",
    "study": "results",
    "statics": "verdict",
    "derivation": "derivation",
    "routine": "routine",
}
"""The stages in order, and the attribute of :class:`Compilation` that holds each one's value."""

VIEWS: Mapping[str, str] = {
    **STAGES,
    "equilibrium": "equilibrium",
    "figure": "figure",
    "bodies": "free_bodies",
}
"""The stages, and what is made only when it is asked for: nothing rests on it."""

SECOND_OPINIONS = ("verdict", "constant_efficiency", "findings", "out_of_step", "gaps")
"""The attributes that hold what statics, the user's ``expect`` lines and the drive say of it."""

EXACT = 15
"""Digits of a value that is handed on to a used mechanism."""

OF_LINKAGES = frozenset(
    {"plan", "balance", "solution", "verdict", "constant_efficiency", "out_of_step", "gaps"}
)
"""The attributes that a calculation sheet has not: nothing moves in it, no force balances another.

Its results are those of its ``calculation``, which a mechanism has not.
"""


def of_linkages(
    stage: "Callable[Concatenate[Compilation, P], T]",
) -> "Callable[Concatenate[Compilation, P], T]":
    """Return a stage that looks at links; of a calculation sheet it is an error (E704)."""

    def run(compilation: "Compilation", /, *args: P.args, **kwargs: P.kwargs) -> T:
        mechanism = compilation.mechanism
        if is_sheet(mechanism):
            raise compilation.report.fail(
                messages.sheet_has_no_links(mechanism.span, mechanism.name)
            )
        return stage(compilation, *args, **kwargs)

    run.__doc__ = stage.__doc__
    return run


class Compilation:
    """One description on its way through the compiler; each stage runs when first asked for."""

    version = VERSION

    def __init__(
        self,
        source: Source,
        settings: Settings | None = None,
        drive: str = "",
        users: tuple[Path, ...] = (),
    ) -> None:
        self.settings = settings or {}
        self.drive = drive
        self.report = Report(attached(source, self.settings))
        self.allowance = Allowance()
        self.users = (*users, *([resolved(Path(source.name))] if source.folder else []))

    @property
    def source(self) -> Source:
        """The text, with those of what it uses once these are read."""
        return self.report.source

    @Stage
    def tree(self) -> ast.File:
        """The tree of the text, in either notation."""
        return self._sound(driven_by(read(self.source, self.report), self.drive))

    @Stage
    def composed(self) -> ast.File:
        """The tree with all that it uses and the settings put in."""
        return self._sound(put_in(self._with_used.file, self.settings, self.source))

    @Stage
    def _with_used(self) -> Composed:
        """The tree with all that it uses, and the solutions of mechanisms among that."""
        return with_used(self.tree, self.report, self.users, self._used)

    def _used(self, source: Source, is_part: bool) -> Used:
        """Return a used description: a sheet, a part, or a mechanism with its solution."""
        from .calculation.from_solution import solved

        used = Compilation(source, users=self.users)
        file, mechanism = used.composed, used.mechanism
        if is_part or is_sheet(mechanism):
            inner = used._with_used
            return Used(file, mechanism, used.source, inner.solved, mechanisms=inner.mechanisms)
        used.verdict  # noqa: B018 - what the free bodies refute is not handed on
        pose = used.pose
        return Used(file, pose.mechanism, used.source, solved(pose, used.solution.results))

    @Stage
    def used_mechanisms(self) -> "tuple[tuple[str, Compilation], ...]":
        """The mechanisms that a sheet uses, by their prefixes, at the values that it gives them."""
        if not self.calculation:
            return ()
        values = {result.name: result.default for result in self.found}
        values |= defaults(self.mechanism)
        return tuple(
            (prefix, self._at_values(source, prefix, values))
            for prefix, source in self._with_used.mechanisms
        )

    def _at_values(
        self, source: Source, prefix: str, values: Mapping[str, float | None]
    ) -> "Compilation":
        """Return a used mechanism with the values that its parameters and loads have here.

        A load of it that follows from another stays open.
        """
        mechanism = Compilation(source, users=self.users).mechanism
        quantities = {p.name: (p.unit, p.dimension) for p in independent(mechanism)}
        quantities |= {k.name: ("", k.dimension) for k in mechanism.loads if k.tie is None}
        units = {let.name: let.unit for let in self.mechanism.lets}
        settings: dict[str, Setting] = {}
        for name, (unit, dimension) in quantities.items():
            here = f"{prefix}_{name}"
            value = values.get(here) if here in self._given_names else None
            if value is not None:
                unit = unit or units.get(here, "") or si_unit(dimension)
                settings |= [parse(f"{name} = {in_unit(value, unit, EXACT)}")]
        return checked(Compilation(source, settings, users=self.users))

    @Stage
    def _given_names(self) -> frozenset[str]:
        """The names that are given values, not formulas that follow from others."""
        given = (ast.Param, ast.Given)
        return frozenset(s.name.text for s in self.composed.statements if isinstance(s, given))

    @Stage
    def mechanism(self) -> Mechanism:
        """Names resolved, quantities in SI, dimensions checked."""
        found = self._sound(resolve(self.composed, self.report))
        literals, parts = self._with_used.solved.literals, self._with_used.parts
        if not literals and not parts:
            return found
        return replace(found, literals=(*found.literals, *literals), subassemblies=parts)

    @Stage
    def pose(self) -> Pose:
        """Every direction, given or found by closing a loop."""
        return self._sound(solve_pose(self.mechanism, self.report))

    @Stage
    @of_linkages
    def plan(self) -> Plan:
        """The order in which velocities follow from one another."""
        return self._sound(plan_velocities(self.pose, self.report))

    @Stage
    @of_linkages
    def balance(self) -> Balance:
        """The power equation, solved for what was asked without friction."""
        return self._sound(balance(self.plan, self.report))

    @Stage
    @of_linkages
    def solution(self) -> Solution:
        """All that was asked for, in the order of the text: with friction, and the user's lets."""
        return self._sound(solve(self.balance, self.report))

    @Stage
    def calculation(self) -> "Calculation | None":
        """The formulas of a calculation sheet with their values; None for a mechanism."""
        if not is_sheet(self.mechanism):
            return None
        from .calculation.from_pose import calculate

        return self._sound(calculate(self.pose, self._with_used.solved, self.report))

    @property
    def found(self) -> tuple[Result, ...]:
        """The results in the order of the text: solved, or calculated."""
        return self.calculation.results if self.calculation else self.solution.results

    @Stage
    def results(self) -> "tuple[Analysis, ...]":
        """The results in the order of the text, with what follows from each."""
        if self.calculation:
            return tuple(map(as_printed, self.found))
        from .study.from_solution import analyse

        return self._sound(analyse(self.solution))

    @Stage
    @of_linkages
    def verdict(self) -> Verdict:
        """The second opinion: the results by equilibrium of the free bodies."""
        return self._sound(cross_check(self.pose, self.solution.results, self.report))

    @Stage
    @of_linkages
    def constant_efficiency(self) -> None:
        """The remarks on an efficiency that is given as one number."""
        if self.pose.mechanism.friction.efficiency is not None:
            from .study.constant_efficiency import remark_on_constant

            remark_on_constant(self.solution, self.report)

    @Stage
    def findings(self) -> tuple[Finding, ...]:
        """The outcome of each ``expect``."""
        pose, results = self.pose, self.found
        definitions = [Definition(*d) for d in pose.definitions]
        return self._sound(compare(pose.mechanism, results, self.report, definitions))

    @Stage
    @of_linkages
    def out_of_step(self) -> tuple[Link, ...]:
        """The links that do not follow the drive."""
        return self._sound(remark(self.plan, self.report))

    @Stage
    @of_linkages
    def gaps(self) -> tuple[tuple[float, float], ...]:
        """The parts of the stroke on which a loop does not close."""
        return self._sound(look_for_gaps(self.plan, self.report))

    @Stage
    def derivation(self) -> "Derivation":
        """The derivation in steps, as on paper; a sheet has none, its results alone."""
        if self.calculation:
            from .report.derivation.steps import calculated

            return calculated(self.results)
        from .report.derivation.from_solution import derive

        return self._sound(derive(self.solution, self.results))

    @Stage
    def reported(self) -> "Derivation":
        """The derivation as a report has it: with the extents of ratios along the stroke.

        It is without that where following the stroke takes more work than is allowed.
        """
        if self.calculation:
            return self.derivation
        from .study.extents import with_extents

        derivation, report = self.derivation, Report(self.source)
        try:
            with within(Allowance(), report):
                results = with_extents(self.solution, self.results, report)
        except MechcError:
            return derivation
        return replace(derivation, results=results)

    @Stage
    @of_linkages
    def equilibrium(self) -> "tuple[Equilibrium, ...]":
        """The sums of forces and moments that lead to each load, body by body."""
        from .equilibrium.from_plan import loads_by_equilibrium

        with within(Allowance(), self.report):
            return self._sound(loads_by_equilibrium(self.plan, self.report))

    @Stage
    @of_linkages
    def by_equilibrium(self) -> "Derivation":
        """The derivation as a report has it, loads by the equilibrium of free bodies."""
        from .report.derivation.equilibrium import derive_by_equilibrium

        return derive_by_equilibrium(self.solution, self.equilibrium, self.reported.results)

    @Stage
    def routine(self) -> Routine:
        """The straight-line program that all targets emit."""
        pose = self.calculation.pose if self.calculation else self.pose
        return self._sound(self.routine_of(pose.mechanism, self.found))

    def routine_of(self, mechanism: Mechanism, results: tuple[Result, ...]) -> Routine:
        """Return the program of results, which may have been changed, at this pose."""
        pose = self.calculation.pose if self.calculation else self.pose
        return program(mechanism, results, dict(pose.definitions), pose.loops, self.motion)

    @Stage
    def motion(self) -> "Motion | None":
        """Coordinates of points and directions of links along the drive; None without one."""
        if self.pose.mechanism.drive is None:
            return None
        from .pose.motion import motion
        from .study.stroke.points_in_step import astray

        return motion(self.pose, astray(self.plan))

    @Stage
    @of_linkages
    def figure(self) -> "Figure | None":
        """The mechanism drawn at the default pose; None where it cannot be assembled."""
        return self.drawn({})

    @of_linkages
    def drawn(self, values: Mapping[str, float]) -> "Figure | None":
        """Return the mechanism drawn at given values, in SI and radians."""
        from .figure.from_pose import draw

        with within(Allowance(), self.report):
            return draw(self.pose, values)

    @Stage
    def scheme(self) -> "Drawing | None":
        """The kinematic scheme at the default pose; None where it cannot be assembled."""
        return self.drawn_scheme("en")

    @Stage
    @of_linkages
    def free_bodies(self) -> "tuple[Diagram, ...]":
        """Each body with the forces on it, at the default pose."""
        return self.cut_free({}, {})

    @of_linkages
    def cut_free(
        self, values: Mapping[str, float], loads: Mapping[str, float]
    ) -> "tuple[Diagram, ...]":
        """Return the free bodies at given values and loads; none where there is no figure."""
        from .statics.diagrams import diagrams

        figure = self.drawn(values) if values else self.figure
        if figure is None:
            return ()
        with within(Allowance(), self.report):
            return diagrams(self.pose, self.solution.results, figure.values, figure.points, loads)

    def titled(self, language: str) -> str:
        """Return the title in a language, if it is translated; the name where there is none."""
        mechanism = self.mechanism
        texts = mechanism.translations.get(language, {})
        return texts.get(mechanism.title, mechanism.title or mechanism.name)

    def drawn_scheme(
        self, language: str, marks: "Marks | None" = None, figure: "Figure | None" = None
    ) -> "Drawing | None":
        """Return the scheme in the words of a language, with marks of how the mechanism moves.

        It is that of the default pose, or of the pose that a figure shows.
        """
        from .drawing.from_figure import scheme
        from .drawing.moving import NO_MARKS

        shown, words = self._pictured(language, figure or self.figure)
        return scheme(shown, words, marks or NO_MARKS) if shown else None

    @of_linkages
    def drawn_bodies(self, language: str) -> "Drawing | None":
        """Return the free bodies drawn, in the words of a language; None where there are none."""
        from .drawing.from_diagrams import free_bodies

        figure, words = self._pictured(language, self.figure)
        return free_bodies(figure, self.free_bodies, words) if figure else None

    def _pictured(
        self, language: str, figure: "Figure | None"
    ) -> "tuple[Figure | None, Mapping[str, str]]":
        """Return a figure with its title in a language, and the words of its pictures."""
        from .report.languages.registry import locale

        titled = figure and replace(figure, title=self.titled(language))
        return titled, locale(language).pictures

    @Stage
    @of_linkages
    def velocities(self) -> "tuple[Velocities, ...]":
        """How every point moves at the default pose, in each independent motion."""
        from .figure.from_balance import velocities

        return velocities(self.balance, self.figure, self.motion) if self.figure else ()

    @of_linkages
    def drawn_plans(self, language: str) -> "Drawing | None":
        """Return the plans of velocities and forces, in the words of a language, if any."""
        from .drawing.from_plans import plans

        figure, words = self._pictured(language, self.figure)
        return plans(figure, self.velocities, self.free_bodies, words) if figure else None

    @of_linkages
    def stroke(self, points: int, paths: Sequence[str] = ()) -> "Stroke":
        """Return the results along the stroke of the drive, in so many rows.

        ``paths`` are the points and links whose motion is shown.
        """
        from .study.stroke.from_balance import run

        motion = self.motion
        with within(Allowance(), self.report):
            return run(self.solution, self.results, points, self.report, motion, paths)

    def along(self, formulas: Settings) -> "Compilation":
        """Return the same description with parameters that follow formulas.

        What it expects is written for values, and is not compared there.
        """
        if not formulas:
            return self
        plain = replace(self.source, attached=())
        constrained = Compilation(plain, {**self.settings, **formulas}, self.drive)
        if not is_sheet(constrained.mechanism):
            constrained.verdict  # noqa: B018
        return constrained

    def plot(self, query: "Query", watch: "Watch" = iter) -> "Plot":
        """Return results against a parameter; ``watch`` sees the curves done one by one."""
        from .plot.dead_centres import with_dead_centres
        from .plot.from_routine import plot

        mechanism, routine = self.pose.mechanism, self.routine
        with within(Allowance(), self.report):
            found = plot(mechanism, routine, query, watch)
            return with_dead_centres(found, self.pose, lambda: self.results)

    def _sound(self, value: T) -> T:
        self.report.stop_on_errors()
        return value


def compile_source(source: Source, settings: Settings | None = None) -> Compilation:
    """Return a compilation that has gone through every stage, second opinions included.

    Raises :class:`MechcError` with all diagnostics of the stage that found errors.
    """
    return complete(Compilation(source, settings))


def complete(compilation: Compilation) -> Compilation:
    """Run every stage that has something to say: all but the program that targets emit."""
    for value in _applying(compilation, (*STAGES.values(), *SECOND_OPINIONS)):
        if value != "routine":
            getattr(compilation, value)
    return compilation


def _applying(compilation: Compilation, values: tuple[str, ...]) -> Iterator[str]:
    """Yield the attributes that a description of this kind has."""
    for value in values:
        if value not in OF_LINKAGES or not is_sheet(compilation.mechanism):
            yield value


def checked(compilation: Compilation) -> Compilation:
    """Run what must agree before anything is emitted, and the stages that it needs."""
    for value in _applying(compilation, SECOND_OPINIONS):
        getattr(compilation, value)
    return compilation


def emit(compilation: Compilation, target: Target, options: Options) -> tuple[Emitted, ...]:
    """Return the files of one target; the first is the main one."""
    return target.emit(checked(compilation), options)


def warnings(compilation: Compilation) -> list[Diagnostic]:
    """Return the warnings so far, in the order of the text."""
    return compilation.report.sorted()
