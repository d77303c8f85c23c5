"""A routine as text, for people: ``mechc show routine``."""

from ..formula.to_text import text
from .steps import Function, Guard, Input, Routine, Solve, Solver, Statement


def to_text(routine: Routine) -> str:
    """Return the whole routine, one function after the other."""
    return "\n\n".join(_function(f) for f in routine.functions) + "\n"


def _function(function: Function) -> str:
    signature = ", ".join(i.name for i in function.inputs)
    lines = [f"{function.name}({signature})  # {function.title}, {function.operations} operations"]
    lines += [f"    # {_input(i)}" for i in function.inputs]
    lines += [f"    {line}" for step in function.steps for line in _statement(step)]
    lines += [f"    require {guard_text(g)}" for g in function.guards]
    return "\n".join([*lines, f"    return {text(function.output)}"])


def _statement(statement: Statement) -> list[str]:
    if not isinstance(statement, Solve):
        return [f"{statement.name} = {text(statement.formula)}"]
    pairs = zip(statement.solver.outer, statement.arguments, strict=True)
    given = ", ".join(f"{name} = {text(value)}" for name, value in pairs)
    return [f"{', '.join(statement.names)} = solution at {given} of", *_solver(statement.solver)]


def _solver(solver: Solver) -> list[str]:
    zeros = [f"    {text(r)} = 0" for r in solver.residuals]
    return [*(f"    {s.name} = {text(s.formula)}" for s in solver.steps), *zeros]


def _input(item: Input) -> str:
    found = [item.name, f"[{item.unit}]" if item.unit else "", item.label]
    if item.low is not None and item.high is not None:
        found.append(f"{item.low:.6g} .. {item.high:.6g} SI")
    return " ".join(part for part in found if part)


def guard_text(guard: Guard) -> str:
    """Return a guard in the notation of the language."""
    return f"{text(guard.left)} {guard.operator} {text(guard.right)}"
