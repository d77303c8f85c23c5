"""A used mechanism as statements: its parameters and loads, its results, what follows from them.

Of a ratio k = P/F one load follows from the other: ``C_P = C_k*C_F`` where F is given.
"""

from collections.abc import Iterator

from ...base.named import NamedTuple
from ...formula.walk import symbols
from ...source import Span
from ...syntax import ast
from ...units import DIMENSIONS, Dimension
from ..mechanism import Efficiency, LoadRatio, Mechanism, WithFriction
from ..parts.loads import Load
from ..parts.targets import whole
from ..result import Result, UsedSolution


class TiedLoad(NamedTuple):
    """A load that a ratio gives from another one: ``above = ratio*below``, or the inverse."""

    name: str
    ratio: str
    other: str
    inverse: bool


def open_loads(mechanism: Mechanism, solved: UsedSolution) -> dict[str, Load]:
    """Return the loads whose value may be given: those that nothing in the mechanism gives."""
    found = {result.name for result in solved.results if result.target is not None}
    return {k.name: k for k in mechanism.loads if k.tie is None and k.name not in found}


def needed(solved: UsedSolution) -> frozenset[str]:
    """Return the names that results leave open."""
    return frozenset[str]().union(*map(_open, solved.results))


def _open(result: Result) -> frozenset[str]:
    parts = [result.formula, *(d.formula for d in result.where)]
    parts += [side for g in result.guards for side in (g.left, g.right)]
    names = frozenset[str]().union(*map(symbols, parts)) - {d.name for d in result.where}
    return names | _open(result.elsewhere) if result.elsewhere else names


def taken(result: Result, use: ast.Use, mechanism: Mechanism) -> ast.Taken:
    """Return the statement that stands for a result, by the names of the used mechanism."""
    rests_on = tuple(ast.Symbol(name, use.span) for name in sorted(_open(result)))
    name = ast.Name(result.name, use.used.span)
    asked, text = _asked(result, mechanism), result.label
    return ast.Taken(use.used.span, name, result.dimension, rests_on, asked, remark=text)


def _asked(result: Result, mechanism: Mechanism) -> Span:
    """Return where a mechanism asks for a result, or for the one that it goes with."""
    places = {let.name: let.span for let in mechanism.lets if result.target is None}
    if result.name in places:
        return places[result.name]
    of = result.target
    if isinstance(of, WithFriction | Efficiency):
        of = of.of
    finds = {find.target: find.span for find in mechanism.finds}
    return finds.get(whole(of), mechanism.span) if of else mechanism.span


def load(known: Load, use: ast.Use) -> ast.Param:
    """Return a load as a parameter that has no value."""
    return ast.Param(
        known.span,
        ast.Name(known.name, use.prefix.span),
        dimension=ast.Name(_dimension(known.dimension), known.span),
    )


def _dimension(dimension: Dimension) -> str:
    return next(name for name, known in DIMENSIONS.items() if known == dimension)


def ratios(solved: UsedSolution) -> Iterator[tuple[str, str]]:
    """Yield the loads of each ratio that was found."""
    for result in solved.results:
        if isinstance(result.target, LoadRatio):
            yield result.target.above, result.target.below


def following(solved: UsedSolution, known: set[str]) -> Iterator[TiedLoad]:
    """Yield the loads that ratios give, of those whose other load is known."""
    ideal = {r.target: r.name for r in solved.results if isinstance(r.target, LoadRatio)}
    names = {r.name for r in solved.results} | known
    for result in solved.results:
        match result.target:
            case (LoadRatio() as ratio) | WithFriction(of=LoadRatio() as ratio) if ratio in ideal:
                ending = result.name.removeprefix(ideal[ratio])
            case _:
                continue
        if ratio.below in known and ratio.above not in known:
            row = TiedLoad(ratio.above + ending, result.name, ratio.below, inverse=False)
        elif ratio.above in known and ratio.below not in known:
            row = TiedLoad(ratio.below + ending, result.name, ratio.above, inverse=True)
        else:
            continue
        if row.name not in names:
            names.add(row.name)
            yield row


def formula(row: TiedLoad, place: Span) -> ast.Follows:
    """Return the formula of a load that a ratio gives."""
    ratio, other = ast.Symbol(row.ratio, place), ast.Symbol(row.other, place)
    factors = ((1, other), (-1, ratio)) if row.inverse else ((1, ratio), (1, other))
    return ast.Follows(place, ast.Name(row.name, place), ast.Product(factors, place))
