"""What the names in a result stand for: inputs, intermediates, other results.

A result's own ``where`` comes first; then parameters, dependent ones by their formula;
then other results (a let may use a find, and gives a load its value); then loads.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence

from ..base.named import NamedTuple
from ..formula.tree import Formula, Symbol
from ..formula.walk import substitute, symbols
from ..model.mechanism import Mechanism
from ..model.result import FrictionResult, Result


class DefinitionKey(NamedTuple):
    """A definition: its name, and the result in whose ``where`` it stands ('' for others)."""

    owner: str
    name: str


class OrderedDefinitions(NamedTuple):
    """Definitions in an order in which each uses only inputs and earlier ones.

    ``names`` gives under which name the formulas asked about find each one, as two
    results may use one name for different things.
    """

    formulas: tuple[tuple[str, Formula], ...]
    names: Mapping[str, str]


class SharedDefinitions(NamedTuple):
    """Definitions of several results, and by the owner under which name each finds its own."""

    formulas: tuple[tuple[str, Formula], ...]
    names: Mapping[str, Mapping[str, str]]


class ProgramScope:
    """The names of one mechanism and its results."""

    def __init__(
        self, mechanism: Mechanism, results: Iterable[Result], definitions: Mapping[str, Formula]
    ) -> None:
        """Index every definition by the name it explains."""
        self.mechanism = mechanism
        self.results = {r.name: r for r in results}
        self.inside = frozenset[str]().union(
            *(r.inside for r in self.results.values() if isinstance(r, FrictionResult))
        )
        self._where = {r.name: {d.name: d.formula for d in r.where} for r in self.results.values()}
        self._place = {o: {n: i for i, n in enumerate(names)} for o, names in self._where.items()}
        self._anywhere = {n: owner for owner, names in self._where.items() for n in names}
        self._used: dict[DefinitionKey, tuple[tuple[str, DefinitionKey], ...]] = {}
        self._posed = frozenset(definitions)
        self._ties = {**definitions, **dict(_ties(mechanism))}
        self._free = {p.name for p in mechanism.parameters}
        self._loads = {load.name for load in mechanism.loads}

    def find(self, owner: str, name: str) -> DefinitionKey | None:
        """Return the key of a name in a result's formulas; None for an input."""
        if name in self._where.get(owner, {}):
            return DefinitionKey(owner, name)
        if name in self._ties:
            return DefinitionKey("", name)
        if name in self._free:
            return None
        if name in self.results and self._is_result(owner, name):
            return DefinitionKey(name, "")
        if name in self._anywhere and name not in self._loads:
            return DefinitionKey(self._anywhere[name], name)
        return None

    def _is_result(self, owner: str, name: str) -> bool:
        """Return whether a name is a result's: a formula's own one, where a condition has it."""
        if name == owner:
            return self.results[name].target is None and name not in self._loads
        return not self._means_the_load(owner, name)

    def _means_the_load(self, owner: str, name: str) -> bool:
        """Return whether the name of a find stands in ``owner`` for its load, not its solution.

        ``find P`` makes P both. In the formulas of finds it is the load; a let means the solution,
        but has that in its ``where``, with the formulas of finds it needs: any P left is a load.
        """
        is_find = self.results[name].target is not None
        result = self.results.get(owner)
        if result is None or not is_find:
            return False
        is_in_find, has_finds_in_where = result.target is not None, bool(self._where[owner])
        return is_in_find or has_finds_in_where

    def formula(self, key: DefinitionKey) -> Formula:
        """Return the formula of a definition."""
        owner, name = key
        if not name:
            return self.results[owner].formula
        return self._where[owner][name] if owner else self._ties[name]

    def definitions(self, owner: str, formulas: Iterable[Formula]) -> OrderedDefinitions:
        """Return all that formulas of a result need, in order."""
        found = self.shared_definitions({owner: formulas})
        return OrderedDefinitions(found.formulas, found.names[owner])

    def shared_definitions(self, asked: Mapping[str, Iterable[Formula]]) -> SharedDefinitions:
        """Return all that formulas of several results need, in order, by their owners."""
        wanted = {
            owner: dict(pair for f in formulas for pair in self._keys(owner, f))
            for owner, formulas in asked.items()
        }
        found, chosen = self._named(key for keys in wanted.values() for key in keys.values())
        names = {owner: {n: chosen[k] for n, k in keys.items()} for owner, keys in wanted.items()}
        return SharedDefinitions(tuple(found.items()), names)

    def free(self, owner: str, formulas: Sequence[Formula]) -> frozenset[str]:
        """Return the names that formulas and the definitions they need leave open."""
        definitions = self.definitions(owner, formulas)
        defined = {name for name, _ in definitions.formulas}
        parts = [rename(f, definitions.names) for f in formulas]
        parts += [formula for _, formula in definitions.formulas]
        return frozenset[str]().union(*map(symbols, parts)) - defined

    def intermediates(self, others: Iterable[str] = ()) -> OrderedDefinitions:
        """Return the pose's definitions in any ``where``, others of it, and all they need."""
        wanted = [
            DefinitionKey(o, n)
            for o, names in self._where.items()
            for n in names
            if n in self._posed
        ]
        wanted += [DefinitionKey("", name) for name in others if name in self._posed]
        found, chosen = self._named(wanted)
        return OrderedDefinitions(tuple(found.items()), {chosen[k]: chosen[k] for k in wanted})

    def _named(
        self, wanted: Iterable[DefinitionKey]
    ) -> tuple[dict[str, Formula], dict[DefinitionKey, str]]:
        """Return all that is needed by the name it gets, and the name of each key."""
        chosen: dict[DefinitionKey, str] = {}
        found: dict[str, Formula] = {}
        for key in self._needs_first(wanted):
            formula = self.formula(key)
            names = {n: chosen[k] for n, k in self._uses(key)}
            formula = rename(formula, names)
            chosen[key] = _free_name(key, formula, found)
            found[chosen[key]] = formula
        return found, chosen

    def _needs_first(self, wanted: Iterable[DefinitionKey]) -> Iterator[DefinitionKey]:
        """Yield every definition reached, each after those that it uses."""
        stack, open_, done = list(wanted)[::-1], set[DefinitionKey](), set[DefinitionKey]()
        while stack:
            key = stack[-1]
            missing = [k for _, k in self._uses(key) if k not in done]
            if missing and key in open_:
                raise LookupError(f"{key.name or key.owner} is defined by itself")
            open_.add(key)
            stack.extend(reversed(missing))
            if not missing:
                if stack.pop() not in done:
                    yield key
                done.add(key)

    def _uses(self, key: DefinitionKey) -> tuple[tuple[str, DefinitionKey], ...]:
        """Return the defined names of a definition's formula, found once."""
        if key not in self._used:
            self._used[key] = tuple(self._keys(key.owner, self.formula(key)))
        return self._used[key]

    def _keys(self, owner: str, formula: Formula) -> Iterator[tuple[str, DefinitionKey]]:
        """Yield the defined names of a formula, those of ``where`` in its order."""
        place = self._place.get(owner, {})
        for name in sorted(symbols(formula), key=lambda n: (place.get(n, len(place)), n)):
            key = self.find(owner, name)
            if key is not None:
                yield name, key


def _ties(mechanism: Mechanism) -> Iterator[tuple[str, Formula]]:
    for parameter in mechanism.parameters:
        if parameter.dependent and parameter.value is not None:
            yield parameter.name, parameter.value
    for load in mechanism.loads:
        if load.tie is not None:
            yield load.name, load.tie


def rename(formula: Formula, names: Mapping[str, str]) -> Formula:
    """Return the formula with symbols renamed; itself where nothing changes."""
    changed = {old: Symbol(new) for old, new in names.items() if old != new}
    return substitute(formula, changed) if changed else formula


def _free_name(key: DefinitionKey, formula: Formula, found: Mapping[str, Formula]) -> str:
    """Return the definition's name, altered where it already means something else."""
    name = key.name or key.owner
    number = 1
    while found.get(name, formula) != formula:
        number += 1
        name = f"{key.name or key.owner}_{number}"
    return name
