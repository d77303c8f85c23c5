"""Formulas of the model as angles and lengths, with named intermediates where needed.

Dependent parameters that angle algebra can look into are put in; the others keep their
names and become definitions (``beta`` where ``beta = asin(…)``).
"""

from ..algebra.angle import Angle
from ..algebra.formula import Formula, substitute
from ..algebra.from_formula import is_transparent, to_angle, to_product
from ..algebra.product import Product
from ..model.mechanism import Mechanism
from ..units import ANGLE
from .pose import Definition


class Terms:
    """Turns formulas into algebra and gathers the definitions that this needs."""

    def __init__(self, mechanism: Mechanism) -> None:
        self.definitions: list[Definition] = []
        self._inner: dict[str, Formula] = {}
        for parameter in mechanism.parameters:
            if parameter.dependent and parameter.value is not None:
                self._define(parameter.name, parameter.value, parameter.dimension == ANGLE)

    def _define(self, name: str, value: Formula, is_angle: bool) -> None:
        formula = self.inner(value)
        if to_angle(formula) is None if is_angle else not is_transparent(to_product(formula)):
            self.definitions.append(Definition(name, formula))
        else:
            self._inner[name] = formula

    def inner(self, formula: Formula) -> Formula:
        """Return a formula with dependent parameters put in."""
        return substitute(formula, self._inner) if self._inner else formula

    def angle(self, formula: Formula, name: str) -> Angle:
        """Return a formula as an angle; what is not linear is defined under a name of its own."""
        formula = self.inner(formula)
        angle = to_angle(formula)
        if angle is not None:
            return angle
        self.definitions.append(Definition(name, formula))
        return Angle.of(name)

    def length(self, formula: Formula) -> Product:
        """Return a formula as a product."""
        return to_product(self.inner(formula))
