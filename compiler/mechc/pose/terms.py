"""Formulas of the model as angles and lengths, with named intermediates where needed.

Dependent parameters that angle algebra can look into are put in; the others keep their
names and become definitions (``beta`` where ``beta = asin(…)``).
"""

from ..algebra.angle import Angle
from ..algebra.from_formula import is_transparent, to_angle, to_product
from ..algebra.product import Product
from ..formula.operations import count_operations
from ..formula.tree import Call, Formula
from ..formula.walk import substitute, symbols
from ..model.mechanism import Mechanism, Parameter
from ..model.values import is_constant
from ..units import ANGLE
from .pose import PoseDefinition

MOST_PUT_IN_OPERATIONS = 40
"""A dependent parameter of more operations than this keeps its name."""


class AlgebraicTerms:
    """Turns formulas into algebra and gathers the definitions that this needs."""

    def __init__(self, mechanism: Mechanism) -> None:
        self.definitions: list[PoseDefinition] = []
        self._inner: dict[str, Formula] = {}
        self._taken = {literal.name for literal in mechanism.literals}
        dependent = {p.name: p for p in mechanism.parameters if p.dependent}
        while dependent:
            self._define(next(iter(dependent.values())), dependent)

    def _define(self, parameter: Parameter, waiting: dict[str, Parameter]) -> None:
        """Put a dependent parameter in or define it, those it needs first."""
        del waiting[parameter.name]
        assert parameter.value is not None
        for name in sorted(symbols(parameter.value) & waiting.keys()):
            if name in waiting:
                self._define(waiting[name], waiting)
        formula = self._inside(parameter.value)
        inner = _angle_formula(formula) if parameter.dimension == ANGLE else _length(formula)
        is_named = is_constant(parameter)
        if inner is not None and not is_named and count_operations(inner) <= MOST_PUT_IN_OPERATIONS:
            self._inner[parameter.name] = inner
        else:
            self.definitions.append(PoseDefinition(parameter.name, formula))

    def _inside(self, formula: Formula) -> Formula:
        return substitute(formula, self._inner) if self._inner else formula

    def angle(self, formula: Formula, name: str) -> Angle:
        """Return a formula as an angle; what is not linear is defined under a name of its own."""
        formula = self._inside(formula)
        angle = to_angle(formula)
        if angle is not None:
            return angle
        return Angle.of(self._defined(name, formula))

    def polar(self, x: Product, y: Product, name: str) -> tuple[Product, Angle]:
        """Return a vector of two components as ``len_name @ phi_name``, both defined."""
        parts = (x.formula(), y.formula())
        angle = self.angle(Call("atan2", parts[::-1]), f"phi_{name}")
        return Product.symbol(self._defined(f"len_{name}", Call("hypot", parts))), angle

    def _defined(self, name: str, formula: Formula) -> str:
        """Define a name, or another like it where it means something else already."""
        while name in self._taken or any(
            d.name == name and d.formula != formula for d in self.definitions
        ):
            name += "_"
        if PoseDefinition(name, formula) not in self.definitions:
            self.definitions.append(PoseDefinition(name, formula))
        return name

    def length(self, formula: Formula) -> Product:
        """Return a formula as a product."""
        return to_product(self._inside(formula))


def _angle_formula(formula: Formula) -> Formula | None:
    angle = to_angle(formula)
    return None if angle is None else angle.formula()


def _length(formula: Formula) -> Formula | None:
    product = to_product(formula)
    return product.formula() if is_transparent(product) else None
