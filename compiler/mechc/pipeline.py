"""The stages from text to results and to the program that code is made of, one after another.

A :class:`Pipeline` holds every stage's value. Each is made when it is first asked for, with
those before it, so that ``fmt`` stops after syntax and ``show pose`` after the pose. A stage
that finds errors ends it with :class:`MechcError`.
"""

from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Concatenate, ParamSpec, TypeVar

from .base.frozen import replace
from .diagnostics import sheets as messages
from .files import resolved
from .friction.from_balance import solve
from .friction.solution import FrictionSolution
from .kinematics.from_pose import plan_velocities
from .kinematics.plan import Plan
from .model.from_syntax import resolve
from .model.mechanism import Link, Mechanism
from .model.result import Definition, Result
from .model.statements import is_sheet
from .model.uses import composing as uses
from .model.uses.composed import Composed, Used, uses_others
from .pose.from_model import solve_pose
from .pose.pose import Pose
from .power.balance import Balance
from .power.from_plan import balance
from .source import Source
from .stage import Stage, within
from .statics.referee import cross_check
from .statics.verdict import Verdict
from .study.analysis import as_printed
from .study.expectations import Finding, compare
from .syntax import ast
from .syntax.notation import read, report_on
from .syntax.settings import Settings, attached, driven_by, with_settings
from .version import VERSION
from .work import Allowance

if TYPE_CHECKING:
    from .calculation.calculation import Calculation
    from .equilibrium.equilibrium import Equilibrium
    from .pose.motion import Motion
    from .report.steps import Derivation
    from .routine.steps import Routine
    from .study.analysis import Analysis

T = TypeVar("T")
P = ParamSpec("P")
Stages = TypeVar("Stages", bound="Pipeline")

STAGES: Mapping[str, str] = {
    "syntax": "composed",
    "model": "described",
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
"""The stages in order, and the attribute of :class:`Pipeline` that holds each one's value."""

SECOND_OPINIONS = (
    *("verdict", "constant_efficiency", "findings", "out_of_step", "gaps", "open_ranges"),
)
"""The attributes that hold what statics, the user's ``expect`` lines and the drive say of it."""

OF_LINKAGES = frozenset(
    {
        *("plan", "balance", "solution", "verdict", "constant_efficiency", "out_of_step", "gaps"),
        "open_ranges",
    }
)
"""The attributes that a calculation sheet has not: nothing moves in it, no force balances another.

Its results are those of its ``calculation``, which a mechanism has not.
"""


def of_linkages(
    stage: "Callable[Concatenate[Stages, P], T]",
) -> "Callable[Concatenate[Stages, P], T]":
    """Return a stage that looks at links; of a calculation sheet it is an error (E704)."""

    def run(pipeline: "Stages", /, *args: P.args, **kwargs: P.kwargs) -> T:
        mechanism = pipeline.mechanism
        if is_sheet(mechanism):
            raise pipeline.report.fail(messages.sheet_has_no_links(mechanism.span, mechanism.name))
        return stage(pipeline, *args, **kwargs)

    run.__doc__ = stage.__doc__
    return run


class Pipeline:
    """One description on its way through the stages; each runs when it is first asked for."""

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
        self.report = report_on(attached(source, self.settings))
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
        return self._sound(with_settings(self._with_used.file, self.settings, self.source))

    @Stage
    def _with_used(self) -> Composed:
        """The tree with all that it uses, and the solutions of mechanisms among that."""
        if not uses_others(self.tree, self.source.text):
            return Composed(self.tree)
        return uses.with_used(self.tree, self.report, self.users, self._used)

    def _used(self, source: Source, is_part: bool) -> Used:
        """Return a used description: a sheet, a part, or a mechanism with its solution."""
        from .calculation.mechanism_results import solved
        from .model.uses.free_coordinates import with_free_coordinates

        used = Pipeline(source, users=self.users)
        file, mechanism = used.composed, used.mechanism
        if is_part or is_sheet(mechanism):
            inner = used._with_used
            return Used(file, mechanism, used.source, inner.solved, mechanisms=inner.mechanisms)
        used.run(["verdict"])  # what the free bodies refute is not handed on
        pose = used.pose
        file = with_free_coordinates(file, pose.mechanism)
        return Used(file, pose.mechanism, used.source, solved(pose, used.solution.results))

    @Stage
    def described(self) -> Mechanism:
        """Names resolved, quantities in SI, dimensions checked; drawn as the text has it."""
        found = self._sound(resolve(self.composed, self.report))
        used = self._with_used
        if not used.parts and not used.prefixes:
            return found
        literals = (*found.literals, *used.solved.literals)
        return replace(found, literals=literals, subassemblies=used.parts, prefixes=used.prefixes)

    @Stage
    def mechanism(self) -> Mechanism:
        """The mechanism where values from outside move what is drawn."""
        return self.described.moved

    @Stage
    def pose(self) -> Pose:
        """Every direction, given or found by closing a loop, of what was drawn first."""
        return self._sound(solve_pose(self.described, self.report))

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
    def solution(self) -> FrictionSolution:
        """All that was asked for, in the order of the text: with friction, and the user's lets."""
        return self._sound(solve(self.balance, self.report))

    @Stage
    def calculated(self) -> "Calculation | None":
        """The formulas of a calculation sheet with their values, whatever its conditions say."""
        if not is_sheet(self.mechanism):
            return None
        from .calculation.from_pose import calculate

        return calculate(self.pose, self._with_used.solved, self.report)

    @Stage
    def calculation(self) -> "Calculation | None":
        """The calculation of a sheet whose conditions hold; None for a mechanism."""
        return self._sound(self.calculated)

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

        return self._sound(analyse(self.solution, self.report))

    @Stage
    @of_linkages
    def verdict(self) -> Verdict:
        """The second opinion: the results by equilibrium of the free bodies.

        It has an allowance of its own, whatever looking along ranges has taken.
        """
        with within(Allowance(), self.report):
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
        if self.pose.mechanism.drive is None:
            return ()
        from .study.stroke.in_step import remark

        return self._sound(remark(self.plan, self.report))

    @Stage
    @of_linkages
    def gaps(self) -> tuple[tuple[float, float], ...]:
        """The parts of the stroke on which a loop does not close."""
        if self.pose.mechanism.drive is None:
            return ()
        from .study.open_loops import remark_on_stroke

        return self._sound(remark_on_stroke(self.plan, self.report))

    @Stage
    @of_linkages
    def open_ranges(self) -> None:
        """The remarks on ranges that reach to where a loop does not close."""
        if self.pose.loops and any(p.range for p in self.pose.mechanism.parameters):
            from .study.open_loops import remark_on_ranges

            remark_on_ranges(self.plan, self.report)

    @Stage
    def derivation(self) -> "Derivation":
        """The derivation in steps, as on paper; a sheet has none, its results alone."""
        if self.calculation:
            from .report.steps import calculated

            return calculated(self.results)
        from .report.derivation.from_solution import derive

        return self._sound(derive(self.solution, self.results, self.forces_at_joints))

    @Stage
    @of_linkages
    def forces_at_joints(self) -> "tuple[Equilibrium, ...]":
        """The sums of forces and moments that lead to forces at joints, where any are asked for."""
        if not any(one.releases for one in self.balance.solved):
            return ()
        from .equilibrium.from_plan import at_joints

        with within(Allowance(), self.report):
            return at_joints(self.pose, self.balance.solved)

    @Stage
    def motion(self) -> "Motion | None":
        """Coordinates of points and directions of links along the drive; None without one."""
        if self.pose.mechanism.drive is None:
            return None
        from .pose.motion import motion
        from .study.stroke.points_in_step import names_out_of_step

        return motion(self.pose, names_out_of_step(self.plan))

    @Stage
    def routine(self) -> "Routine":
        """The straight-line program that all targets emit."""
        pose = self.calculation.pose if self.calculation else self.pose
        return self._sound(self.routine_of(pose.mechanism, self.found))

    def routine_of(self, mechanism: Mechanism, results: tuple[Result, ...]) -> "Routine":
        """Return the program of results, which may have been changed, at this pose."""
        from .routine.from_results import program

        pose = self.calculation.pose if self.calculation else self.pose
        return program(mechanism, results, dict(pose.definitions), pose.loops, self.motion)

    def run(self, values: Iterable[str]) -> None:
        """Run the stages that make these values, for what they report.

        A calculation sheet is not asked for what only linkages have.
        """
        for value in values:
            if value not in OF_LINKAGES or not is_sheet(self.mechanism):
                getattr(self, value)

    def so_far(self) -> dict[str, object]:
        """Return the values of the stages that have run, by the stages' names."""
        own = vars(self)
        return {stage: own[value] for stage, value in STAGES.items() if value in own}

    def _sound(self, value: T) -> T:
        self.report.stop_on_errors()
        return value
