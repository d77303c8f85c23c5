"""Whether quantities measure what is wanted of them, or the same as one another."""

from collections.abc import Iterable

from ...base.named import NamedTuple
from ...diagnostics.model import quantities
from ...formula.to_text import text
from ...formula.tree import Formula, Symbol
from ...source import Span
from ...units import Dimension
from ..constants import rational, too_large
from ..names.scope import NameScope, UnitlessNumber
from .sorts import Nature, Sort, agreed


class MeasuredFormula(NamedTuple):
    """A formula in SI, what it measures and where it stands."""

    formula: Formula
    sort: Sort
    span: Span

    @property
    def dimension(self) -> Dimension:
        """Return the dimension."""
        return self.sort.dimension


def shown(formula: Formula) -> str:
    """Return a number without unit for a message."""
    value = rational(formula)
    return text(formula) if value is None or too_large(value) else f"{float(value):g}"


def fits(found: MeasuredFormula, dimension: Dimension, what: str, scope: NameScope) -> bool:
    """Return whether a quantity measures what is wanted; report where it does not."""
    if found.sort.fits(dimension):
        return True
    if found.sort.nature is Nature.BARE:
        digits = shown(found.formula)
        scope.report.add(quantities.bare_number(found.span, digits, dimension))
    elif bare := _bare(found, scope):
        scope.doubt(found.formula)
        scope.report.add(quantities.bare_number(bare.span, bare.digits, dimension, found.span))
    else:
        _report_dimension(found, dimension, what, scope)
    return False


def _report_dimension(
    found: MeasuredFormula, dimension: Dimension, what: str, scope: NameScope
) -> None:
    """Report a quantity of another dimension: of a name once, with where it is declared."""
    name = found.formula.name if isinstance(found.formula, Symbol) else ""
    declared = scope.declared(name)
    if declared and not scope.first_misfit(name, dimension):
        return
    message = quantities.wrong_dimension(
        found.span, found.dimension, dimension, what, name, declared
    )
    if message.span == declared:
        scope.doubt(found.formula)
    scope.report.add(message)


def _bare(found: MeasuredFormula, scope: NameScope) -> UnitlessNumber | None:
    """Return the number without unit that a quantity is made of, where it is one."""
    unitless = found.sort.nature is Nature.UNITLESS
    return scope.unitless_number(found.formula) if unitless else None


def alike(parts: list[MeasuredFormula], act: str, scope: NameScope) -> Sort | None:
    """Return the sort that parts of a sum or comparison share; report where they do not."""
    if not parts:
        return None
    first, *rest = parts
    sort = first.sort
    anchor = first
    for part in rest:
        both = agreed(sort, part.sort)
        if both is None:
            _differ(anchor, part, act, scope)
            return None
        if both != sort:
            sort, anchor = both, part
    return sort


def _differ(first: MeasuredFormula, part: MeasuredFormula, act: str, scope: NameScope) -> None:
    """Report two parts of a sum or comparison that do not measure the same."""
    for bare, other in ((part, first), (first, part)):
        if bare.sort.nature is Nature.BARE or _bare(bare, scope):
            fits(bare, other.dimension, "a term", scope)
            return
    scope.report.add(
        quantities.mixed_dimensions(
            part.span,
            part.dimension,
            first.span,
            first.dimension,
            act,
            _names((first, part), scope),
        )
    )


def _names(parts: Iterable[MeasuredFormula], scope: NameScope) -> list[tuple[str, Span]]:
    """Return the names among quantities, and where each is declared."""
    names = [part.formula.name for part in parts if isinstance(part.formula, Symbol)]
    places = [(name, scope.declared(name)) for name in names]
    return [(name, place) for name, place in places if place]
