"""What every find is answered from: the power equations, and which loads follow from which."""

from collections.abc import Callable, Mapping, Sequence
from functools import cache
from typing import TYPE_CHECKING

from ..algebra.matrices import determinant
from ..algebra.product import Product
from ..base.frozen import frozen
from ..diagnostics import Report
from ..diagnostics import power as messages
from ..formula.differences import with_positive_sines
from ..formula.tree import Formula
from ..kinematics.plan import Plan
from ..model.mechanism import Find, Load, LoadForm, LoadRatio, Mechanism
from ..model.parts.friction import PivotFriction
from ..model.result import Result
from ..units import Dimension
from . import reactions
from .balance import PowerEquations, Term, equations_of
from .definitions import open_lengths, resting_on
from .loads import given_size, terms
from .numbers import DefaultNumbers, is_zero_everywhere
from .reading import RatioReader

if TYPE_CHECKING:
    from .reactions import Reactions


@frozen
class PowerProblem:
    """The power equations of a plan, and the loads in them.

    ``asked_for`` are the loads that do work and are asked for, ``left`` those that work, have
    no size and are not asked for. ``reactions`` gives the forces at joints, found once, ``values``
    are those at the default pose.
    """

    plan: Plan
    terms: tuple[Term, ...]
    equations: PowerEquations
    reading: RatioReader
    report: Report
    loads: Mapping[str, Load]
    asked_for: tuple[str, ...]
    left: tuple[str, ...]
    reactions: "Callable[[], Reactions]"
    numbers: DefaultNumbers

    @property
    def mechanism(self) -> Mechanism:
        """Return the mechanism whose loads they are."""
        return self.plan.graph.pose.mechanism

    @property
    def driving(self) -> tuple[str, ...]:
        """Return the loads that follow from the others: those asked for, else those left."""
        return (*self.asked_for, *self.left)[: self.equations.number]

    @property
    def undecided(self) -> tuple[str, ...]:
        """Return the loads of which nothing says which ones follow from the others."""
        open_ = self.equations.number - len(self.asked_for)
        if open_ < 0:
            return self.asked_for
        return self.left if 0 < open_ < len(self.left) else ()

    @property
    def balances_at_zero_alone(self) -> bool:
        """Return whether the loads that do work balance where they are zero, and nowhere else.

        Friction balances them, too, where what does no work, or a given thrust, presses joints.
        """
        joints = self.mechanism.friction.joints
        is_loaded = self.equations.idle_loads or any(isinstance(k, PivotFriction) for k in joints)
        return self._is_square and not (joints and is_loaded) and not self.cancels_but_for_rounding

    @property
    def cancels_but_for_rounding(self) -> bool:
        """Return whether only rounding keeps tied loads from balancing whatever they are."""
        if not self._is_square:
            return False
        power = determinant([*self.equations.columns.values()])
        formula, pose = power.formula(), self.plan.graph.pose
        return is_zero_everywhere(formula, resting_on(self.plan, formula, [power]), pose)

    @property
    def _is_square(self) -> bool:
        """Return whether there are as many loads that do work as equations, and any."""
        return 0 < len(self.equations.columns) == self.equations.number

    def given(self, load: str) -> Formula | None:
        """Return the size that the description gives a load."""
        return given_size(self.mechanism, load)

    def dimension(self, load: str) -> Dimension:
        """Return the dimension of a load: that of a force, or of a moment. KeyError for no load."""
        return self.loads[load].dimension

    def result(
        self, find: Find, formula: Formula, dimension: Dimension, values: Sequence[Product]
    ) -> Result:
        """Return a formula as a result, with the definitions that it rests on."""
        formula = self.with_positive_sines(formula)
        where = resting_on(self.reading.plan, formula, values)
        self.check_lengths(find, [formula, *(d.formula for d in where)])
        return Result(find.name, find.target, dimension, formula, where)

    def with_positive_sines(self, formula: Formula) -> Formula:
        """Return a formula with its angles and differences as they are at the default pose."""
        return with_positive_sines(formula, lambda: self.numbers.values, self.reading.quarter)

    def check_lengths(self, find: Find, formulas: Sequence[Formula]) -> None:
        """Report what is asked for where a length has no value that its formulas need."""
        if missing := open_lengths(self.plan, formulas):
            self.report.add_first(messages.length_not_given(find.span, find.name, missing))


def problem_of(plan: Plan, report: Report) -> PowerProblem:
    """Return the power equations of a plan, and what is known of their loads."""
    mechanism, parts = plan.graph.pose.mechanism, terms(plan)
    equations = equations_of(parts)
    asked = _asked_for(mechanism, equations)
    works = equations.columns
    left = tuple(n for n in works if not given_size(mechanism, n) and n not in asked)
    loads = {load.name: load for load in mechanism.loads}

    @cache
    def at_joints() -> "Reactions":
        return reactions.Reactions(plan.graph.pose, problem.driving, known=(plan,))

    reading, numbers = RatioReader(plan), DefaultNumbers(plan)
    problem = PowerProblem(
        plan=plan,
        terms=parts,
        equations=equations,
        reading=reading,
        report=report,
        loads=loads,
        asked_for=asked,
        left=left,
        reactions=at_joints,
        numbers=numbers,
    )
    return problem


def _asked_for(mechanism: Mechanism, equations: PowerEquations) -> tuple[str, ...]:
    """Return the free loads of what is asked for, P of P/F or a load alone, that do work."""
    targets = [f.target for f in mechanism.finds]
    asked = [t.above for t in targets if isinstance(t, LoadRatio)]
    asked += [t.load for t in targets if isinstance(t, LoadForm)]
    free = dict.fromkeys(load for load, _ in map(equations.owner, asked))
    return tuple(load for load in free if load in equations.columns)
