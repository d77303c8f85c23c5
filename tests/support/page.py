"""A report read back from its LaTeX, formula by formula, with the numbers of the default pose.

What a name stands for is taken from where the page defines it; where it gives no formula (a
force that is found by iteration, a number of few digits), the value of code stands for it.
"""

import math
import re
from collections.abc import Iterator, Mapping

from latex_reader import read
from mechc.compilation import Compilation
from mechc.emit.latex.to_latex import TARGET
from mechc.emit.target import Options
from mechc.formula.evaluate import evaluate
from mechc.formula.tree import Call, Formula, number
from mechc.formula.walk import children, rebuild, symbols
from mechc.friction import at_rest
from mechc.model.values import completed, holds
from mechc.report.latex.document_style import style_of
from mechc.report.latex.notation import name, notation
from mechc.routine.evaluate import evaluate as run
from mechc.study.analysis import Analysis

SHOWN = re.compile(
    r"\\\[\n(.*?)\n\\\]|\\begin\{(align\*|multline\*)\}\n(.*?)\n\\end\{\2\}", re.DOTALL
)
NAME = re.compile(
    r"(?:\\[A-Za-z]+|[A-Za-z])'*_(?:\{(?:[^{}]|\{(?:[^{}]|\{[^{}]*\})*\})*\}|\w)|\\[A-Z][a-z]+"
)
"""A name with an index, or a capital Greek letter."""

DIGITS = 2e-5
"""What constants that are printed in six figures may be off."""

ROUNDED_ZERO = 1e-8
"""A smaller number may be zero: angles at the end of a loop have half the digits of others."""

ZERO, LEFT_OF_ZERO = 1e-12, 1e-6
"""What is zero but for rounding, and what constants in six figures may leave of it."""


class Page:
    """The equations of a report, and what its names stand for."""

    def __init__(self, compilation: Compilation, by: str = "power") -> None:
        self.compilation = compilation
        (emitted,) = TARGET.emit(compilation, Options("page", numbers=False, by=by))
        self.tex = emitted.text
        results = compilation.derivation.results
        self.style = style_of(compilation.mechanism, results, notation("en"))
        self.code = dict(self._values())
        self.spelled = {name(symbol, self.style): value for symbol, value in self.code.items()}
        self.open = {name(r.name, self.style) for r in compilation.results if not self._holds(r)}

    def _values(self) -> Iterator[tuple[str, float]]:
        """Yield the values of all names at the default pose, loads without one being 1."""
        functions = self.compilation.routine.functions
        inputs = {i.name: i.default for f in functions for i in f.inputs}
        values = {n: 1.0 if default is None else default for n, default in inputs.items()}
        for literal in self.compilation.mechanism.literals:
            values[literal.name] = evaluate(literal.value, {})
        values |= {f.name: float(run(f, values)) for f in functions}
        for result in self.compilation.results:
            new = (d for d in result.where if d.name not in values)
            values = completed(values, ((d.name, _on_paper(d.formula)) for d in new))
        yield from values.items()

    def printed(self) -> dict[str, float]:
        """Return the values of names that have one, by how they are spelled, as they are printed.

        Where a joint does not slide for an instant that is the limit, which code has beside it.
        """
        values = {**self.spelled, **dict(self._limits())}
        return {name: value for name, value in values.items() if name not in self.open}

    def _limits(self) -> Iterator[tuple[str, float]]:
        """Yield what code comes to beside the default pose, of results with one limit there."""
        for result in self.compilation.results:
            if len(result.sides) == 1:
                function = next(
                    f for f in self.compilation.routine.functions if f.name == result.name
                )
                moved = at_rest.values_nearby(result, self.compilation.pose)
                farther = {n: 2 * x - self.code[n] for n, x in moved.items()}
                near, far = (run(function, {**self.code, **at}) for at in (moved, farther))
                yield name(result.name, self.style), float(2 * near - far)

    def _holds(self, result: Analysis) -> bool:
        """Tell whether a result has a value here, by the case that is printed."""
        conditions = (*result.holds, *result.guards)
        has_value = math.isfinite(self.code[result.name]) and not result.undetermined
        return has_value and all(holds(c, self.code) for c in conditions)

    def equations(self) -> Iterator[tuple[str, ...]]:
        """Yield what stands between the equals signs of each equation."""
        for single, _, several in SHOWN.findall(self.tex):
            text = re.sub(r"\\\\\*?(\[2pt\])?\s*&\\quad\{\}", " ", single or several)
            for line in re.split(r"\\\\\*?(?:\[2pt\])?\n|&\n", text):
                line = line.removeprefix(r"\boxed{").removesuffix("}" if r"\boxed" in line else "")
                yield tuple(part.strip() for part in line.replace("&=", "=").split("="))

    def wrong(self) -> Iterator[str]:
        """Yield each definition and result that has another value than the name on its left."""
        known = dict(self.spelled)
        for left, *rights in self.equations():
            for right in rights:
                value = self._value(right, known)
                if (
                    value is None
                    or left in self.open
                    or not (left in known or NAME.fullmatch(left))
                ):
                    continue
                meant = known.setdefault(left, value)
                if math.isnan(value) or math.isnan(meant):
                    continue
                zero = LEFT_OF_ZERO if abs(meant) < ZERO else ROUNDED_ZERO
                if not math.isclose(value, meant, rel_tol=DIGITS, abs_tol=zero):
                    yield f"{left} is {meant}, not {value} = {right}"

    def _value(self, tex: str, known: Mapping[str, float]) -> float | None:
        """Return the value of a formula; None where it is none, or a name in it has no value."""
        if r"\text" in tex or not tex:
            return None
        formula = read(tex, {*known, *NAME.findall(tex)})
        if not symbols(formula) <= known.keys():
            return None
        return evaluate(formula, known)


def _on_paper(formula: Formula) -> Formula:
    """Return a formula in which the sign of what is zero but for rounding is zero."""
    parts = tuple(map(_on_paper, children(formula)))
    if isinstance(formula, Call) and formula.function in ("sign", "sense"):
        return Call("sense", (parts[0], number(1)))
    return rebuild(formula, parts)
