"""Whether the formula that is printed of a result with friction holds at the default pose."""

from math import isclose, isfinite

from ..formula.evaluate import evaluate
from ..formula.rounding import Rounded, Rounding
from ..formula.tree import Call, Formula, is_call
from ..formula.walk import symbols
from ..model.mechanism import Efficiency, WithFriction
from ..model.values import Values, holds
from .analysis import Analysis

ALIKE = 1e-6
"""What a printed formula may be off its value by rounding, as a part of it."""


def fails_here(result: Analysis, values: Values) -> bool:
    """Return whether the value of a result is not what its formula comes to, as it is printed.

    Friction alone may make the force in a rod that bears nothing without it: the sign of its
    force is that of 0 on paper, and one by which all forces balance in code.
    """
    if result.default is None or not isinstance(result.target, WithFriction | Efficiency):
        return False
    if not result.guards and not any(is_call(d.formula, "sign") for d in result.where):
        return False
    rounding = Rounding(values)
    for name, formula in result.where:
        if name not in rounding.values and symbols(formula) <= rounding.values.keys():
            rounding.values[name] = _on_paper(formula, rounding)
    known = {name: found.value for name, found in rounding.values.items()}
    if not all(holds(guard, known) for guard in result.guards):
        return True
    if not symbols(result.formula) <= known.keys():
        return False
    value = evaluate(result.formula, known)
    return isfinite(value) and not isclose(value, result.default, rel_tol=ALIKE, abs_tol=ALIKE**2)


def _on_paper(formula: Formula, rounding: Rounding) -> Rounded:
    """Return the value of a definition: 0 of the sign of what is zero but for rounding."""
    match formula:
        case Call("sign", (inner,)) if rounding.of(inner).is_zero:
            return Rounded(0.0, 0.0)
        case _:
            return rounding.of(formula)
