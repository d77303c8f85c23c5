"""How a ratio of loads is read: multiplied out, as the speeds stand, or by ratios of speeds."""

from collections.abc import Callable, Iterable, Iterator
from functools import cached_property

from ..algebra.product import Product
from ..algebra.sums import is_long, readable
from ..formula.operations import count_operations
from ..formula.rewriting import Quarter
from ..formula.tree import Formula
from ..formula.walk import symbols
from ..kinematics.plan import Plan
from ..kinematics.readable import ReadablePlan, in_ratios, readable_plan
from ..model.mechanism import Mechanism
from ..pose.given_angles import given_lines
from .balance import PowerEquations, equations_of
from .definitions import bound_sums, resting_on
from .loads import terms
from .numbers import default_values

UNREAD_OPERATIONS = 64
"""Operations of a ratio that nobody reads: the canonical form is not kept for its own sake."""

GLANCE_OPERATIONS = 24
"""Operations that are taken in at a glance: a longer ratio may rest on named ratios of speeds."""


class RatioReader:
    """Writes ratios as they are read; ``plan`` is the one that has the names they mention."""

    def __init__(self, plan: Plan) -> None:
        self._plan, self._is_closed = plan, bool(plan.graph.pose.definitions)
        self._rests_on_ratios = False

    @property
    def plan(self) -> Plan:
        """Return the plan off which speeds are read."""
        if self._rests_on_ratios:
            return self._ratios
        return self._readable if self._is_closed and not self._plan.bindings else self._plan

    @cached_property
    def quarter(self) -> Quarter | None:
        """Return the quarter turns that bring angles to those between given lines."""
        return given_lines(self._plan.graph.pose)

    def read(self, value: Product, solved: Callable[[PowerEquations], Product]) -> Product:
        """Return a ratio as it is read, and note the plan that it rests on.

        ``solved`` gives it by power equations.
        In the free angles of an open pose k has one form, however the mechanism is written
        down, unless that is too long to be read.
        """
        if self._plan.bindings or not is_long(value):
            return value
        if not self._is_closed and count_operations(value.formula()) <= UNREAD_OPERATIONS:
            return value
        short = readable(value, [solved(equations_of(terms(self._readable)))])
        if self._plan.mobility > 1 or count_operations(short.formula()) <= GLANCE_OPERATIONS:
            return short
        nested = solved(equations_of(terms(self._ratios)))
        where = self._rests_on(nested)
        is_longer = sum(map(count_operations, where)) > count_operations(short.formula())
        if is_longer or not _names_in(where) <= self._known(value) | set(self._ratio_names):
            return short
        self._rests_on_ratios = True
        return nested

    @cached_property
    def _readable(self) -> ReadablePlan:
        return readable_plan(self._plan)

    @cached_property
    def _ratios(self) -> ReadablePlan:
        pose = self._plan.graph.pose
        taken = frozenset((*_names(pose.mechanism), *(d.name for d in pose.definitions)))
        return in_ratios(self._plan, default_values(self._plan), taken)

    @property
    def _ratio_names(self) -> Iterator[str]:
        return (binding.name for binding in self._ratios.bindings)

    def _known(self, value: Product) -> set[str]:
        """Return the names in a ratio and in the definitions that it rests on."""
        formula = value.formula()
        return _names_in([formula, *(d.formula for d in resting_on(self._plan, formula, [value]))])

    def _rests_on(self, nested: Product) -> list[Formula]:
        """Return a ratio of loads with the ratios of speeds that it rests on."""
        return [nested.formula(), *(d.formula for d in bound_sums(self._ratios, [nested]))]


def _names_in(formulas: Iterable[Formula]) -> set[str]:
    return {name for formula in formulas for name in symbols(formula)}


def _names(mechanism: Mechanism) -> Iterator[str]:
    """Yield the names that a description gives to quantities."""
    named = (mechanism.parameters, mechanism.literals, mechanism.loads)
    yield from (item.name for items in named for item in items)
    yield from (item.name for items in (mechanism.finds, mechanism.lets) for item in items)
