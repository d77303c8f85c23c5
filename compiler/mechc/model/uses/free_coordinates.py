"""The coordinate that drives a used mechanism, where the drawing gives its value.

``drive OA`` declares no parameter, and ``param phi: angle`` one without a value. A sheet that
uses the mechanism has it among its own, so that it may be given, and set from outside.
"""

from ...base.frozen import replace
from ...formula.evaluate import evaluate
from ...formula.tree import Formula
from ...syntax import ast
from ...units import si_unit, size_of
from ..mechanism import Mechanism, Parameter
from ..statements import every


def with_free_coordinates(file: ast.File, mechanism: Mechanism) -> ast.File:
    """Return a file in which each free coordinate is declared with the value of the drawing."""
    free = {p.name: p for p in mechanism.parameters if p.value and not p.dependent}
    declared = {param.name.text for param in every(file, ast.Param)}
    own = (_with_value(statement, free) for statement in file.statements)
    made_up = (_as_param(p) for name, p in free.items() if name not in declared)
    return replace(file, statements=(*own, *made_up))


def _with_value(statement: ast.Statement, free: dict[str, Parameter]) -> ast.Statement:
    """Return a statement; a parameter that has no value in it has that of the drawing."""
    match statement:
        case ast.Param(name=name, value=None) if parameter := free.get(name.text):
            return replace(statement, value=_number(parameter.value, parameter), dimension=None)
        case _:
            return statement


def _as_param(parameter: Parameter) -> ast.Param:
    """Return the line ``param`` that would give a parameter its value and its range."""
    ends = parameter.range
    return ast.Param(
        parameter.span,
        ast.Name(parameter.name, parameter.span),
        _number(parameter.value, parameter),
        _number(ends.low, parameter) if ends else None,
        _number(ends.high, parameter) if ends else None,
    )


def _number(value: Formula | None, parameter: Parameter) -> ast.Number | None:
    """Return a number in the unit of a parameter, without the last digit, which is rounding."""
    if value is None:
        return None
    unit = parameter.unit or si_unit(parameter.dimension)
    return ast.Number(f"{evaluate(value, {}) / size_of(unit):.15g}", unit, parameter.span)
