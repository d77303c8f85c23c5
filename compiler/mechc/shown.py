"""What a mechanism hands out, showing itself in a notebook: results, derivation, stroke."""

from collections.abc import Mapping
from typing import TypeVar

from .base.frozen import contents, field, frozen
from .compilation import Compilation, checked
from .emit.latex import notebook
from .formula.to_text import text
from .report.steps import Derivation
from .report.text.stroke import to_html
from .study.analysis import Analysis
from .study.stroke.stroke import Stroke

T = TypeVar("T")


@frozen
class ShownResult(Analysis):
    """A result that a notebook shows as a formula, with all that it rests on."""

    of: Compilation = field(compare=False, kw_only=True)

    def _repr_markdown_(self) -> str:
        return notebook.results(checked(self.of), (self,))

    def _repr_latex_(self) -> str:
        return notebook.results_in_latex(checked(self.of), (self,))

    def __repr__(self) -> str:
        """Return name and formula in one line."""
        return f"<{self.name} = {text(self.formula)}>"


@frozen
class ShownDerivation(Derivation):
    """A derivation that a notebook shows as it stands on paper."""

    of: Compilation = field(compare=False, kw_only=True)

    def _repr_markdown_(self) -> str:
        return notebook.derivation(checked(self.of))

    def _repr_latex_(self) -> str:
        return notebook.derivation_in_latex(checked(self.of))

    def __repr__(self) -> str:
        """Return the mechanism and the number of steps."""
        return f"<derivation of {self.of.mechanism.name}: {len(self.steps)} steps>"


@frozen
class ShownStroke(Stroke):
    """A stroke that a notebook shows as a table."""

    def table(self) -> Mapping[str, list[float]]:
        """Return the values by the names of their columns, the drive first; SI and radians.

        NaN where there is none. ``pandas.DataFrame(stroke.table())`` takes it.

        >>> import mechc
        >>> table = mechc.load("crank_rocker").stroke(3).table()
        >>> list(table), table["phi"]
        (['phi', 'k', 'i', 'dk/dphi', 'V_B/omega_O1A', 'mu_B'], [0.0, 3.141592653589793, 6.28...])
        """
        names = [self.drive, *(column.name for column in self.columns)]
        rows = [(row.drive, *row.values) for row in self.rows]
        return {name: [row[i] for row in rows] for i, name in enumerate(names)}

    def _repr_html_(self) -> str:
        return to_html(self)

    def __repr__(self) -> str:
        """Return drive, results and the number of rows in one line."""
        results = (c.name for c in self.columns if c.content == "result")
        return f"<stroke over {self.drive}: {', '.join(results)}; {len(self.rows)} rows>"


def shown(kind: type[T], value: object, **more: object) -> T:
    """Return a value as one of the classes above."""
    return kind(**contents(value, value), **more)
