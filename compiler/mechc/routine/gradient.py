"""A result and its slopes by all inputs in one pass: the steps forwards, then back.

Backwards each step hands on the result's derivative by it (its adjoint) to what it was
computed from. So all slopes together cost a few times the result, however many inputs
there are, where differences cost as many results as there are inputs.
"""

from collections import defaultdict
from collections.abc import Iterable, Sequence
from fractions import Fraction
from itertools import count

from ..formula.choices import CONDITIONS, SIGNS, equal_within
from ..formula.derivative import partials
from ..formula.tree import (
    ONE,
    ZERO,
    Call,
    Formula,
    Implicit,
    Number,
    Power,
    Product,
    Sum,
    Symbol,
    negative,
    number,
    power,
    product,
    total,
)
from ..formula.walk import symbols
from .lengths import fresh
from .sharing import share
from .steps import Function, Guard, PoseProgram, Solve, Step
from .unit_vectors import reached


def gradients(functions: Iterable[Function]) -> list[tuple[Function, PoseProgram]]:
    """Return functions with the programs of their slopes, those that have one and take inputs."""
    found = ((f, gradient(f)) for f in functions if f.inputs)
    return [(function, program) for function, program in found if program]


def gradient(function: Function) -> PoseProgram | None:
    """Return a program of a result and its slopes by each input; None where it iterates.

    Outputs are the result and the slopes in the order of the inputs. Where a condition fails
    all are NaN.
    """
    steps = [step for step in function.steps if not isinstance(step, Solve)]
    if len(steps) < len(function.steps):
        return None
    inputs = [i.name for i in function.inputs]
    taken = {*inputs, *(step.name for step in steps)}
    titles = (function.name, *(f"d{function.name}_d{name}" for name in inputs))
    value, *slopes = (fresh(title, taken) for title in titles)
    holds, back = _holding(function.guards), _Backwards(steps, inputs, taken)
    back.add(function.output, holds, Symbol(value))
    back.run(steps)
    definitions = [
        *((step.name, step.formula) for step in steps),
        (value, _times(function.output, holds)),
        *back.written,
        *((title, back.slope(name)) for title, name in zip(slopes, inputs, strict=True)),
    ]
    outputs = (value, *slopes)
    needed = reached(definitions, [], outputs)
    return PoseProgram(function.inputs, share(needed, [], inputs).steps, outputs, (value,))


def _holding(guards: Sequence[Guard]) -> Formula:
    """Return 1 where all conditions hold, else NaN."""
    conditions = [_condition(guard) for guard in guards]
    return product([(Call("choose", (c, ONE)), 1) for c in conditions]) if conditions else ONE


MINUS_ONE = number(-1)


class _Backwards:
    """Gathers the adjoint of each name; ``written`` are the definitions of adjoints."""

    def __init__(self, steps: Sequence[Step], inputs: Sequence[str], taken: set[str]) -> None:
        self.taken = taken
        self.written: list[tuple[str, Formula]] = []
        self._numbers = count(1)
        self._terms: defaultdict[str, list[Formula]] = defaultdict(list)
        self._moving = set(inputs)
        for step in steps:
            if not self._moving.isdisjoint(symbols(step.formula)):
                self._moving.add(step.name)

    def slope(self, name: str) -> Formula:
        """Return the derivative of the output by a name, as summed so far."""
        return total(self._terms[name])

    def run(self, steps: Sequence[Step]) -> None:
        """Hand on the adjoints of steps, the last first."""
        for step in reversed(steps):
            if self._terms[step.name]:
                title = fresh(f"by_{step.name}", self.taken)
                self.written.append((title, self.slope(step.name)))
                self.add(step.formula, Symbol(title), Symbol(step.name))

    def add(self, formula: Formula, adjoint: Formula, value: Formula | None = None) -> None:
        """Hand on a formula's adjoint to the names in it; ``value`` is a name for the formula."""
        if self._moving.isdisjoint(symbols(formula)):
            return
        match formula:
            case Symbol(name):
                self._terms[name].append(adjoint)
            case Sum(terms):
                named = self._named(adjoint)
                for term in terms:
                    self.add(term, named)
            case Product(factors):
                self._add_factors(factors, adjoint, value or formula)
            case Power(base, exponent):
                self._add_power(base, exponent, adjoint, value or formula)
            case Call(function, arguments):
                for argument, slope in zip(arguments, _slopes(function, arguments), strict=True):
                    self.add(argument, _times(adjoint, slope))
            case Implicit():
                raise TypeError("a solution is a step of its own")

    def _add_factors(self, factors: tuple[Formula, ...], adjoint: Formula, value: Formula) -> None:
        below = [f.base for f in factors if isinstance(f, Power) and f.exponent == MINUS_ONE]
        above = [f for f in factors if not (isinstance(f, Power) and f.exponent == MINUS_ONE)]
        share_of_each = self._named(product([(adjoint, 1), *((base, -1) for base in below)]))
        for i, factor in enumerate(above):
            others = ((other, 1) for j, other in enumerate(above) if j != i)
            self.add(factor, product([(share_of_each, 1), *others]))
        for base in below:
            self.add(base, _over(_times(adjoint, negative(value)), base))

    def _named(self, formula: Formula) -> Formula:
        """Return a name for what is used several times; numbers and names stay as they are."""
        if isinstance(formula, Symbol | Number):
            return formula
        title = fresh(f"w{next(self._numbers)}", self.taken)
        self.written.append((title, formula))
        return Symbol(title)

    def _add_power(
        self, base: Formula, exponent: Formula, adjoint: Formula, value: Formula
    ) -> None:
        if isinstance(exponent, Number) and exponent.value > 0:
            lower = power(base, Number(exponent.value - 1))
            self.add(base, product([(adjoint, 1), (exponent, 1), (lower, 1)]))
        else:
            self.add(base, _over(product([(adjoint, 1), (exponent, 1), (value, 1)]), base))
        self.add(exponent, product([(adjoint, 1), (value, 1), (Call("log", (base,)), 1)]))


def _condition(guard: Guard) -> Formula:
    if guard.operator == "=":
        return Call("at_most", equal_within(guard.left, guard.right))
    return Call(CONDITIONS[guard.operator], (guard.left, guard.right))


def _slopes(function: str, arguments: tuple[Formula, ...]) -> list[Formula]:
    """Return the slope of a call by each argument; a choice follows what is chosen."""
    match function, arguments:
        case "sqrt", (x,):
            return [product([(Number(Fraction(1, 2)), 1), (Call("sqrt", (x,)), -1)])]
        case "choose", (condition, _):
            return [ZERO, Call("choose", (condition, ONE))]
        case "choose", (condition, _, _):
            return [
                ZERO,
                *(Call("choose", (condition, *pair)) for pair in ((ONE, ZERO), (ZERO, ONE))),
            ]
        case (("min" | "max"), (x, y)):
            return _either(Call("at_most" if function == "min" else "at_least", (x, y)))
        case _ if function in SIGNS:
            return [ZERO] * len(arguments)
        case _:
            return partials(function, arguments)


def _either(first: Formula) -> list[Formula]:
    """Return 1 and 0 where the first of two is chosen, 0 and 1 elsewhere."""
    return [Call("choose", (first, *pair)) for pair in ((ONE, ZERO), (ZERO, ONE))]


def _times(a: Formula, b: Formula) -> Formula:
    return product([(a, 1), (b, 1)])


def _over(a: Formula, b: Formula) -> Formula:
    return product([(a, 1), (b, -1)])
