"""The straight-line program: what every target emits and the interpreter runs.

Language-neutral: SI units and radians, names from the drawing (each target renames
what its language forbids). Each step's formula mentions inputs and earlier steps
only. Parts that occur twice are steps of their own. The number of steps grows
linearly with the mechanism.
"""

from typing import Literal

from ..formula.tree import Formula
from ..frozen import frozen
from ..units import Dimension


@frozen
class Input:
    """A free parameter: what it is, its unit as the user writes it, default and range in SI."""

    name: str
    dimension: Dimension
    unit: str = ""
    default: float | None = None
    low: float | None = None
    high: float | None = None
    label: str = ""


@frozen
class Step:
    """``name = formula``."""

    name: str
    formula: Formula


@frozen
class Guard:
    """A ``require``: where ``left OP right`` is false, the output is NaN."""

    left: Formula
    operator: Literal["<", "<=", ">", ">=", "=", "!="]
    right: Formula


@frozen
class Function:
    """One result: inputs in declared order, only those it depends on.

    ``formula`` is the result as a reader sees it, with ``where`` defining the named
    intermediates it mentions, in order; ``steps`` compute the same, shared parts once,
    and ``output`` is the formula of the last line (usually one symbol or a short
    product). ``operations`` counts ``steps`` and ``output``.
    """

    name: str
    title: str
    inputs: tuple[Input, ...]
    guards: tuple[Guard, ...]
    steps: tuple[Step, ...]
    output: Formula
    formula: Formula
    where: tuple[Step, ...]
    dimension: Dimension
    operations: int


@frozen
class Routine:
    """All functions of one mechanism."""

    name: str
    title: str
    source: str
    functions: tuple[Function, ...]
