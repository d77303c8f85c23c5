"""The solution of a mechanism, under the names that it has where it is used."""

from collections.abc import Callable

from ...base.frozen import on_demand, replace
from ...formula.tree import Constant, Formula, Implicit, Symbol
from ...formula.walk import children, rebuild
from ..mechanism import Parameter, Require
from ..parts.targets import Efficiency, LoadForm, LoadRatio, ResultTarget, WithFriction
from ..result import (
    ClosedLoop,
    Definition,
    DrivingLoad,
    FrictionResult,
    Result,
    SignCase,
    UsedSolution,
)

Rename = Callable[[str], str]


def prefixed(solved: UsedSolution, prefix: str, by: int) -> UsedSolution:
    """Return the solution with a prefix before every name, and its spans moved on."""
    return _Renaming(prefix, by).solved(solved)


class _Renaming:
    """Puts a prefix before names; formulas that share parts share them afterwards."""

    def __init__(self, prefix: str, by: int) -> None:
        self._prefix, self._by = prefix, by
        self._known: dict[int, tuple[Formula, Formula]] = {}

    def solved(self, found: UsedSolution) -> UsedSolution:
        return UsedSolution(
            tuple(map(self._result, found.results)),
            self._definitions(found.definitions),
            tuple(map(self._loop, found.loops)),
            tuple(map(self._require, found.requires)),
            tuple(map(self._literal, found.literals)),
        )

    def _name(self, name: str) -> str:
        return f"{self._prefix}_{name}"

    def _formula(self, formula: Formula) -> Formula:
        if id(formula) not in self._known:
            self._known[id(formula)] = formula, self._renamed(formula)
        return self._known[id(formula)][1]

    def _renamed(self, formula: Formula) -> Formula:
        """Return a formula with the prefix before all names in it."""
        match formula:
            case Constant(name, value):
                return Constant(self._name(name), value)
            case Symbol(name):
                return Symbol(self._name(name))
            case Implicit(system, index, arguments):
                # The names of a system are its own, but for those of numbers.
                return Implicit(system, index, tuple(map(self._formula, arguments)))
        parts = children(formula)
        return rebuild(formula, tuple(map(self._formula, parts))) if parts else formula

    def _definitions(self, found: tuple[Definition, ...]) -> tuple[Definition, ...]:
        return tuple(Definition(self._name(d.name), self._formula(d.formula)) for d in found)

    def _loop(self, loop: ClosedLoop) -> ClosedLoop:
        of = self._name(loop.of) if loop.of else self._prefix
        names = frozenset(map(self._name, loop.names))
        return ClosedLoop(loop.loop, names, self._formula(loop.margin), of)

    def _require(self, require: Require) -> Require:
        left, right = self._formula(require.left), self._formula(require.right)
        return replace(require, left=left, right=right, span=require.span.moved(self._by))

    def _requires(self, found: tuple[Require, ...]) -> tuple[Require, ...]:
        return tuple(map(self._require, found))

    def _literal(self, literal: Parameter) -> Parameter:
        return replace(literal, name=self._name(literal.name), span=literal.span.moved(self._by))

    def _result(self, result: Result) -> Result:
        """Return a result under its prefix, with all that it holds."""
        changed = replace(
            result,
            name=self._name(result.name),
            target=_of_loads(result.target, self._name) if result.target else None,
            formula=self._formula(result.formula),
            where=self._definitions(result.where),
            coefficients=None,
            guards=self._requires(result.guards),
            elsewhere=on_demand(lambda: self._elsewhere(result)),
        )
        if not isinstance(changed, FrictionResult):
            return changed
        return replace(
            changed,
            case=changed.case and self._case(changed.case),
            inside=frozenset(map(self._name, changed.inside)),
            drive=changed.drive and DrivingLoad(*map(self._formula, changed.drive)),
        )

    def _elsewhere(self, result: Result) -> Result | None:
        return self._result(result.elsewhere) if result.elsewhere else None

    def _case(self, case: SignCase) -> SignCase:
        return SignCase(
            self._formula(case.formula),
            self._definitions(case.where),
            self._requires(case.holds),
            self._requires(case.guards),
        )


def _of_loads(target: ResultTarget, rename: Rename) -> ResultTarget:
    """Return a target whose loads have other names; points and links keep theirs."""
    match target:
        case LoadRatio(above, below):
            return LoadRatio(rename(above), rename(below))
        case LoadForm(load):
            return LoadForm(rename(load))
        case WithFriction(of=LoadRatio() | LoadForm() as of) | Efficiency(of=of):
            return replace(target, of=_of_loads(of, rename))
        case _:
            return target
