"""A routine as text, for people: ``mechc show routine``."""

from ..formula.to_text import text
from .steps import Function, Guard, Input, Routine


def to_text(routine: Routine) -> str:
    """Return the whole routine, one function after the other."""
    return "\n\n".join(_function(f) for f in routine.functions) + "\n"


def _function(function: Function) -> str:
    signature = ", ".join(i.name for i in function.inputs)
    lines = [f"{function.name}({signature})  # {function.title}, {function.operations} operations"]
    lines += [f"    # {_input(i)}" for i in function.inputs]
    lines += [f"    {step.name} = {text(step.formula)}" for step in function.steps]
    lines += [f"    require {guard_text(g)}" for g in function.guards]
    return "\n".join([*lines, f"    return {text(function.output)}"])


def _input(item: Input) -> str:
    found = [item.name, f"[{item.unit}]" if item.unit else "", item.label]
    if item.low is not None and item.high is not None:
        found.append(f"{item.low:.6g} .. {item.high:.6g} SI")
    return " ".join(part for part in found if part)


def guard_text(guard: Guard) -> str:
    """Return a guard in the notation of the language."""
    return f"{text(guard.left)} {guard.operator} {text(guard.right)}"
