"""The compiler from text to emitted files: the stages, and what is made when it is asked for.

The stages stand in :mod:`.pipeline`. What nothing rests on, pictures, motion along the stroke,
plots and the derivation by equilibrium, is made of their values here.
"""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from .base.frozen import replace
from .base.named import NamedTuple
from .diagnostics import Diagnostic, MechcError, Report
from .model.mechanism import Mechanism
from .model.values import defaults, independent
from .pipeline import SECOND_OPINIONS, STAGES, Pipeline, of_linkages
from .source import Source
from .stage import Stage, within
from .syntax import ast
from .syntax.settings import Setting, Settings, parse
from .units import in_unit, si_unit
from .work import MOST_WORK, Allowance

if TYPE_CHECKING:
    from .drawing.drawing import Drawing
    from .drawing.moving import Marks
    from .emit.target import Emitted, Options, Target
    from .equilibrium.equilibrium import Equilibrium
    from .figure.figure import Figure
    from .figure.velocities import MotionVelocities
    from .plot.from_routine import Watch
    from .plot.plot import Plot
    from .plot.query import Query
    from .report.steps import Derivation
    from .statics.diagrams.diagram import Diagram
    from .study.stroke.from_balance import Watch as Drives
    from .study.stroke.stroke import Stroke

VIEWS: Mapping[str, str] = {
    **STAGES,
    "equilibrium": "equilibrium",
    "figure": "figure",
    "bodies": "free_bodies",
}
"""The stages, and what is made only when it is asked for: nothing rests on it."""

OF_WHAT_IS_FOUND = ("derivation", "routine")
"""The stages that no message comes from."""

ALONG = 4
"""How much more work a stroke may take than a compilation: it is looked at at 721 places."""

OF_A_ROW = MOST_WORK // 100
"""Steps that each row of a stroke may take: with friction in all joints it takes some thousands."""

EXACT = 15
"""Digits of a value that is handed on to a used mechanism."""


class Compilation(Pipeline):
    """A description in the compiler: its stages, and all that can be made of their values."""

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
        units = {let.name: let.unit for let in self.mechanism.lets}
        given = {
            name: GivenValue(value, units.get(here, ""))
            for name in (q.name for q in (*mechanism.parameters, *mechanism.loads))
            if (here := f"{prefix}_{name}") in self._given_names
            and (value := values.get(here)) is not None
        }
        return checked(Compilation(source, settings_of(mechanism, given), users=self.users))

    @Stage
    def _given_names(self) -> frozenset[str]:
        """The names that are given values, not formulas that follow from others."""
        given = (ast.Param, ast.Given)
        return frozenset(s.name.text for s in self.composed.statements if isinstance(s, given))

    @Stage
    def reported(self) -> "Derivation":
        """The derivation as a report has it: with extents of ratios, with names for directions."""
        if self.calculation:
            return self.derivation
        return self._with_directions(self._along_stroke)

    def _with_directions(self, derivation: "Derivation") -> "Derivation":
        """Return a derivation with names for directions, of which loops alone make long sums."""
        if not self.pose.closing:
            return derivation
        from .report.directions import in_derivation

        return in_derivation(derivation, self.pose)

    @Stage
    def _along_stroke(self) -> "Derivation":
        """The derivation with the extents of ratios along the stroke.

        It is without that where following the stroke takes more work than is allowed.
        """
        from .study.extents import with_extents

        derivation, report = self.derivation, Report(self.source)
        try:
            with within(Allowance(), report):
                results = with_extents(self.solution, derivation.results, report)
        except MechcError:
            return derivation
        return replace(derivation, results=results)

    @Stage
    @of_linkages
    def equilibrium(self) -> "tuple[Equilibrium, ...]":
        """The sums of forces and moments that lead to loads and forces, body by body."""
        from .equilibrium.from_plan import by_equilibrium

        with within(Allowance(), self.report):
            return self._sound(by_equilibrium(self.plan, self.balance.solved, self.report))

    @Stage
    @of_linkages
    def by_equilibrium(self) -> "Derivation":
        """The derivation as a report has it, loads by the equilibrium of free bodies."""
        from .report.derivation.equilibrium import derive_by_equilibrium

        results = self._along_stroke.results
        found = derive_by_equilibrium(self.solution, self.equilibrium, results)
        return self._with_directions(found)

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
        from .statics.diagrams.to_diagrams import diagrams

        figure = self.drawn(values) if values else self.figure
        if figure is None:
            return ()
        with within(Allowance(), self.report):
            nearby = {} if values else self._next_to_rest()
            results = self.solution.results
            return diagrams(self.pose, results, figure.values, figure.points, loads, nearby)

    def _next_to_rest(self) -> Mapping[str, float]:
        """Return the values of a pose near the default one, where results are the limit there."""
        from .friction import at_rest

        resting = (r for r in self.solution.results if len(r.sides) == 1)
        moved = next((at_rest.values_nearby(r, self.pose) for r in resting), {})
        figure = self.drawn(moved) if moved else None
        return figure.values if figure else {}

    def titled(self, language: str) -> str:
        """Return the title in a language, if it is translated; the name where there is none."""
        mechanism = self.mechanism
        texts = mechanism.texts(language)
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
        """Return a figure with its texts in a language, and the words of its pictures."""
        from .figure.figure import with_links_called
        from .report.languages.registry import locale

        texts = self.mechanism.texts(language)
        called = figure and with_links_called(figure, texts)
        titled = called and replace(called, title=self.titled(language))
        return titled, locale(language).pictures

    @Stage
    @of_linkages
    def velocities(self) -> "tuple[MotionVelocities, ...]":
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
    def stroke(self, points: int, paths: Sequence[str] = (), watch: "Drives" = iter) -> "Stroke":
        """Return the results along the stroke of the drive, in so many rows.

        ``paths`` are the points and links whose motion is shown; ``watch`` sees the rows done.
        """
        from .study.stroke.from_balance import run

        motion = self.motion
        with within(Allowance(ALONG * MOST_WORK + points * OF_A_ROW), self.report):
            return run(self.solution, self.results, points, self.report, motion, paths, watch)

    def along(self, formulas: Settings) -> "Compilation":
        """Return the same description with parameters that follow formulas.

        What it expects is written for values, and is not compared there.
        """
        if not formulas:
            return self
        plain = replace(self.source, attached=())
        constrained = Compilation(plain, {**self.settings, **formulas}, self.drive)
        constrained.run(["verdict"])
        return constrained

    def plot(self, query: "Query", watch: "Watch" = iter) -> "Plot":
        """Return results against a parameter; ``watch`` sees the curves done one by one."""
        from .plot.dead_centres import with_dead_centres
        from .plot.from_routine import plot

        mechanism, routine = self.pose.mechanism, self.routine
        with within(Allowance(), self.report):
            found = plot(mechanism, routine, query, watch)
            return with_dead_centres(found, self.pose, lambda: self.results)


class GivenValue(NamedTuple):
    """A value in SI that is given from outside, and the unit that it has there, if any."""

    value: float
    unit: str


def settings_of(mechanism: Mechanism, given: Mapping[str, GivenValue]) -> Settings:
    """Return the settings that give a mechanism values, each in its own unit or that of its giver.

    What follows from something else in the mechanism stays open.
    """
    units = {p.name: (p.unit, p.dimension) for p in independent(mechanism)}
    units |= {k.name: ("", k.dimension) for k in mechanism.loads if k.tie is None}
    settings: dict[str, Setting] = {}
    for name in (n for n in units if n in given):
        unit, dimension = units[name]
        value, there = given[name]
        settings |= [
            parse(f"{name} = {in_unit(value, unit or there or si_unit(dimension), EXACT)}")
        ]
    return settings


def compile_source(source: Source, settings: Settings | None = None) -> Compilation:
    """Return a compilation that has gone through every stage of :func:`complete`.

    Raises :class:`MechcError` with all diagnostics of the stage that found errors.
    """
    return complete(Compilation(source, settings))


def complete(compilation: Compilation) -> Compilation:
    """Run every stage that has something to say of a description, second opinions included.

    The derivation and the program are made of what is found, and say nothing more; they wait
    until they are asked for.
    """
    stages = (stage for stage in STAGES if stage not in OF_WHAT_IS_FOUND)
    compilation.run((*map(STAGES.__getitem__, stages), *SECOND_OPINIONS))
    return compilation


def checked(compilation: Compilation) -> Compilation:
    """Run what must agree before anything is emitted, and the stages that it needs."""
    compilation.run(SECOND_OPINIONS)
    return compilation


def emit(compilation: Compilation, target: "Target", options: "Options") -> "tuple[Emitted, ...]":
    """Return the files of one target; the first is the main one."""
    compiled = checked(compilation)
    with within(Allowance(), compilation.report):
        return target.emit(compiled, options)


def warnings(compilation: Compilation) -> list[Diagnostic]:
    """Return the warnings so far, in the order of the text."""
    return compilation.report.sorted()
