"""The sets of loads under which forces are shown: what is given, and what follows."""

from collections.abc import Iterable, Iterator, Mapping, Sequence

from ..formula.evaluate import evaluate
from ..formula.walk import symbols
from ..frozen import frozen
from ..model.mechanism import Axial, LoadForm, LoadRatio, Mechanism, Normal, Reaction
from ..model.result import Result
from ..named import NamedTuple

LoadSizes = Mapping[str, float]


class LoadCase(NamedTuple):
    """Loads of known sizes; those that ``known`` does not name follow from them.

    ``scale`` is the size of a load to which all forces are scaled in the end.
    """

    result: str
    sizes: LoadSizes
    known: frozenset[str]
    per: str = ""
    left_out: tuple[str, ...] = ()
    scale: tuple[str, float] | None = None


def cases(mechanism: Mechanism, results: Sequence[Result], given: LoadSizes) -> list[LoadCase]:
    """Return the loads that each result takes as given, at the sizes that they have."""
    return list(_distinct(_Loads(mechanism, results, given).cases()))


def sizes_of(mechanism: Mechanism, values: LoadSizes, given: LoadSizes) -> dict[str, float]:
    """Return the size, in N or N·m, of every load that has one: given, or by the description.

    A tie to a load without a size gives none. ``values`` are those of names, in SI.
    """
    found = dict(given)
    for load in mechanism.loads:
        if load.name in found:
            continue
        if load.name in values:
            found[load.name] = values[load.name]
        elif load.tie is not None and symbols(load.tie) <= values.keys():
            found[load.name] = evaluate(load.tie, values)
    return found


def _distinct(cases: Iterable[LoadCase]) -> Iterator[LoadCase]:
    """Yield the cases but for those whose diagrams would be the same again."""
    seen = set()
    for case in cases:
        key = case.known, frozenset(case.sizes)
        if key not in seen:
            seen.add(key)
            yield case


@frozen
class _Loads:
    """The loads of a mechanism, of which some have a size, and what was asked about them."""

    mechanism: Mechanism
    results: Sequence[Result]
    given: LoadSizes

    @property
    def _names(self) -> set[str]:
        return {load.name for load in self.mechanism.loads}

    @property
    def _tied(self) -> set[str]:
        return {load.name for load in self.mechanism.loads if load.tie is not None}

    @property
    def _valued(self) -> set[str]:
        """Return the loads that the description takes as known."""
        return self._tied | ({let.name for let in self.mechanism.lets} & self._names)

    def cases(self) -> Iterator[LoadCase]:
        """Yield the loads that act together, result by result."""
        targets = [result.target for result in self.results]
        solved = {target.load for target in targets if isinstance(target, LoadForm)}
        ratios = any(isinstance(target, LoadRatio) for target in targets)
        for result in self.results:
            match result.target:
                case LoadRatio(above, below):
                    yield self._ratio(result.name, above, below)
                case LoadForm(load):
                    open_ = {load, *(solved - set(result.coefficients or {}))}
                    yield from self._one_by_one(result.name, frozenset(self._names - open_))
                case Reaction() | Axial() | Normal() if not solved and not ratios:
                    acting = result.coefficients or symbols(result.formula)
                    known = self._names & {*self._valued, *acting}
                    yield from self._one_by_one(result.name, frozenset(known))
                case _:
                    pass

    def _ratio(self, result: str, above: str, below: str) -> LoadCase:
        """Return the case of a ratio: at the size of either load, else per unit of the second."""
        known = frozenset((self._valued | {below}) - {above})
        if below in self.given:
            return LoadCase(result, self._of(known), known)
        others = tuple(n for n in self.given if n in known)
        if above in self.given:
            return LoadCase(result, {below: 1.0}, known, "", others, (above, self.given[above]))
        return LoadCase(result, {below: 1.0}, known, below, others)

    def _one_by_one(self, result: str, known: frozenset[str]) -> Iterator[LoadCase]:
        """Yield all loads of given sizes at once, and those without one by one.

        Where friction is all that the load has to overcome, as in a clutch, there is none.
        """
        sized = self._of(known)
        free = known - sized.keys() - self._tied
        open_ = [load.name for load in self.mechanism.loads if load.name in free]
        if sized or not (known or self.mechanism.friction.joints == ()):
            yield LoadCase(result, sized, known, left_out=tuple(open_))
        for name in open_:
            others = tuple(n for n in (*sized, *open_) if n != name)
            yield LoadCase(result, {name: 1.0}, known, name, others)

    def _of(self, names: frozenset[str]) -> LoadSizes:
        return {name: size for name, size in self.given.items() if name in names}
