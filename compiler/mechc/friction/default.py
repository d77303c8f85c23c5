"""A result with friction as it is printed: its case at the default pose."""

from collections.abc import Callable, Iterator, Mapping, Sequence, Set

from ..formula.evaluate import evaluate
from ..formula.tree import Formula, is_call
from ..formula.walk import symbols
from ..kinematics.plan import Plan
from ..model.boxes import POSITIVE, allowed_box
from ..model.result import Definition
from ..model.values import Chain, completed
from ..power.numbers import default_values
from .closed_form import Printed
from .free_bodies import EquationsCoupled
from .naming import Meanings, OwnNames
from .signs import AtOnePose


class DefaultPose:
    """The default pose's values; ``valued`` are loads of known size, by formula."""

    def __init__(self, plan: Plan, valued: Mapping[str, Formula], taken: Set[str]) -> None:
        self._mechanism = plan.graph.pose.mechanism
        self._plan, self._valued, self._taken = plan, valued, taken
        self.meanings = Meanings()

    def printed(
        self, way: Callable[[AtOnePose], Printed], endings: Sequence[str]
    ) -> Printed | None:
        """Return the printed result at the pose; None where a value or a sign is missing."""
        values = self.values()
        box = {**allowed_box(self._mechanism), **dict.fromkeys(self._distances(), POSITIVE)}
        taken = values.keys() | self._taken
        try:
            found = way(
                AtOnePose(taken, self.meanings, endings, values, box, OwnNames(self._own()))
            )
        except (KeyError, EquationsCoupled):
            return None
        self.meanings.note(found.where)
        return found

    def _distances(self) -> Iterator[str]:
        """Yield the lengths that are distances of points: where one is 0, nothing has a value."""
        for name, formula in self._plan.graph.pose.definitions:
            if is_call(formula, "hypot"):
                yield name

    def _own(self) -> Iterator[Definition]:
        """Yield the user's own formulas of parameters alone, each after those it needs."""
        known = {p.name for p in (*self._mechanism.parameters, *self._mechanism.literals)}
        for name, formula in Chain(
            {let.name: let.value for let in self._mechanism.lets}
        ).definitions:
            if symbols(formula) <= known:
                known.add(name)
                yield Definition(name, formula)

    def balances(self, printed: Printed) -> bool:
        """Return whether forces have at the pose the senses that a printed result gives them."""
        known = completed(self.values(), printed.where)
        return all(evaluate(force, known) > 0 for force in printed.positive)

    def values(self) -> dict[str, float]:
        """Return the values, with loads of unknown size near 1, none like another.

        Equal ones may cancel in a joint; the order of lines may not change them.
        """
        loads = sorted(self._mechanism.loads, key=lambda load: load.name)
        values = {load.name: 1 + i / 7 for i, load in enumerate(loads)}
        values |= default_values(self._plan)
        for name, formula in self._valued.items():
            if symbols(formula) <= values.keys():
                values[name] = evaluate(formula, values)
        return values
