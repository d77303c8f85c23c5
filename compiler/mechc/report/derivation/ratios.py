"""Ratios of speeds that results rest on by name, as the steps give them."""

from ...formula.tree import Symbol, quotient
from ...kinematics.graph import Kind
from ...kinematics.plan import Plan
from ...units import FREQUENCY, VELOCITY, Dimension
from .notation import Notation
from .steps import Equation, NamedRatio


class Ratios:
    """The ratios with a name in the plan that formulas are read off; ``found`` are those shown."""

    def __init__(self, read: Plan, notation: Notation) -> None:
        self._read, self._notation = read, notation
        self.found: list[NamedRatio] = []

    def of(self, unknown: int) -> tuple[Equation, ...]:
        """Return the equations of an unknown's ratio to the drive, where it has a name."""
        ratio = self._read.ratios.get(unknown)
        if ratio is None:
            return ()
        above, below = unknown, self._read.drives[0]
        dimension = self._rate(above).over(self._rate(below))
        found = NamedRatio(ratio.name, ratio.value.formula(), dimension)
        self.found.append(found)
        speeds = (self._notation.of_itself(u).symbol for u in (above, below))
        name = Symbol(found.name)
        return Equation(name, quotient(*speeds)), Equation(name, found.formula)

    def _rate(self, unknown: int) -> Dimension:
        kind = self._read.graph.unknowns[unknown].kind
        return FREQUENCY if kind is Kind.SPIN else VELOCITY
