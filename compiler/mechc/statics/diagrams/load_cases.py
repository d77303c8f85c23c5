"""The sets of loads under which forces are shown: what is given, and what follows."""

from collections.abc import Iterable, Iterator, Mapping, Sequence

from ...base.named import NamedTuple
from ...formula.evaluate import evaluate
from ...formula.walk import symbols
from ...model.mechanism import Axial, LoadForm, LoadRatio, Mechanism, Normal, Reaction
from ...model.result import Result

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
    return list(_distinct(_by_result(results, _known_loads(mechanism, given))))


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


class _KnownLoads(NamedTuple):
    """The loads of a mechanism, in its order, and what is known of them before a result is asked.

    ``tied`` are a formula of others, ``determined`` are those and the ones that a ``let`` gives;
    ``sizes`` are what somebody gave. ``has_friction`` is whether a joint has any.
    """

    names: tuple[str, ...]
    tied: frozenset[str]
    determined: frozenset[str]
    sizes: LoadSizes
    has_friction: bool

    def sized(self, names: frozenset[str]) -> LoadSizes:
        """Return the given sizes of some loads."""
        return {name: size for name, size in self.sizes.items() if name in names}


def _known_loads(mechanism: Mechanism, sizes: LoadSizes) -> _KnownLoads:
    names = tuple(load.name for load in mechanism.loads)
    tied = frozenset(load.name for load in mechanism.loads if load.tie is not None)
    lets = {let.name for let in mechanism.lets}
    determined = tied | lets.intersection(names)
    return _KnownLoads(names, tied, determined, sizes, mechanism.friction.joints != ())


def _by_result(results: Sequence[Result], loads: _KnownLoads) -> Iterator[LoadCase]:
    """Yield the loads that act together, result by result.

    Forces at joints have cases of their own only where no load is found from others.
    """
    found = {r.target.load for r in results if isinstance(r.target, LoadForm)}
    is_of_joints = not any(isinstance(r.target, LoadForm | LoadRatio) for r in results)
    for result in results:
        match result.target:
            case LoadRatio(above, below):
                yield _of_ratio(result.name, above, below, loads)
            case LoadForm(load):
                unknown = {load, *(found - set(result.coefficients or {}))}
                yield from _one_by_one(result.name, frozenset(loads.names) - unknown, loads)
            case Reaction() | Axial() | Normal() if is_of_joints:
                acting = result.coefficients or symbols(result.formula)
                known = loads.determined | set(acting)
                yield from _one_by_one(result.name, known.intersection(loads.names), loads)
            case _:
                pass


def _of_ratio(result: str, above: str, below: str, loads: _KnownLoads) -> LoadCase:
    """Return the case of a ratio: at the size of either load, else per unit of the second."""
    known = (loads.determined | {below}) - {above}
    if below in loads.sizes:
        return LoadCase(result, loads.sized(known), known)
    others = tuple(n for n in loads.sizes if n in known)
    if above in loads.sizes:
        return LoadCase(result, {below: 1.0}, known, "", others, (above, loads.sizes[above]))
    return LoadCase(result, {below: 1.0}, known, below, others)


def _one_by_one(result: str, known: frozenset[str], loads: _KnownLoads) -> Iterator[LoadCase]:
    """Yield all loads of given sizes at once, and those without one by one.

    Where friction is all that the load has to overcome, as in a clutch, there is none.
    """
    sized = loads.sized(known)
    without = known - sized.keys() - loads.tied
    unsized = [name for name in loads.names if name in without]
    if sized or (not known and loads.has_friction):
        yield LoadCase(result, sized, known, left_out=tuple(unsized))
    for name in unsized:
        others = tuple(n for n in (*sized, *unsized) if n != name)
        yield LoadCase(result, {name: 1.0}, known, name, others)
