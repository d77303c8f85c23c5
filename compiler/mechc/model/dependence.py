"""What rests on which quantities: results, places and joints, a calculation as a whole."""

from collections.abc import Iterable, Iterator, Mapping, Sequence, Set

from ..base.frozen import contents, fields
from ..formula.tree import Formula
from ..formula.walk import symbols
from .mechanism import Mechanism
from .result import Result

NameSet = Set[str]


def unused(mechanism: Mechanism, results: Sequence[Result]) -> tuple[str, ...]:
    """Return the quantities and tables of used sheets that have no part in a calculation.

    Nothing of the sheet's own rests on them, no condition and no ``expect``, and they rest on
    nothing of its own; what a used mechanism gives may rest on that, as all its forces do on its
    load. A sheet that calculates nothing itself shows all that it uses.
    """
    lets = [let.name for let in mechanism.lets]
    if not set(lets) - mechanism.brought:
        return ()
    rests = rests_on(mechanism, results)
    quantities = [*(p.name for p in mechanism.parameters), *lets]
    given = mechanism.follow | {known.name for known in mechanism.taken}
    own = set(quantities) - mechanism.brought
    shown = below((_above(own, rests) - given) | _checked(mechanism), rests)
    names = (*quantities, *(k.name for k in mechanism.taken), *(t.name for t in mechanism.tables))
    return tuple(name for name in names if name in mechanism.brought - shown)


def _checked(mechanism: Mechanism) -> NameSet:
    """Return the names that conditions are on, and of which a value is expected."""
    conditions = (r for r in mechanism.requires if not r.subject)
    names = {name for r in conditions for side in (r.left, r.right) for name in symbols(side)}
    return names | {expect.subject for expect in mechanism.expects}


def rests_on(mechanism: Mechanism, results: Iterable[Result]) -> Mapping[str, NameSet]:
    """Return the quantities that each one rests on, and the table that it is looked up in."""
    rests = {p.name: symbols(p.value) for p in mechanism.parameters if p.value}
    for let in mechanism.lets:
        table = {let.written.of} if let.written else frozenset()
        rests[let.name] = symbols(let.value) | table
    for result in results:
        parts = (result.formula, *(d.formula for d in result.where))
        rests.setdefault(result.name, frozenset().union(*map(symbols, parts)))
    return rests


def _above(names: NameSet, rests: Mapping[str, NameSet]) -> NameSet:
    """Return names, with all that rest on one of them."""
    found = set(names)
    while more := {name for name in rests.keys() - found if rests[name] & found}:
        found |= more
    return found


def below(names: NameSet, rests: Mapping[str, NameSet]) -> NameSet:
    """Return names, with all that they rest on."""
    found = set(names)
    while more := {n for name in found & rests.keys() for n in rests[name]} - found:
        found |= more
    return found


def in_geometry(mechanism: Mechanism) -> frozenset[str]:
    """Return the parameters by which places, lengths, directions and joints are given.

    Those that these follow from are among them; what gives loads alone is not.
    """
    whole = (mechanism.geometry, mechanism.drawn, mechanism.joints, mechanism.slides)
    ways = [getattr(load, "along", None) for load in mechanism.loads]
    named = frozenset[str]().union(*_names((whole, ways, mechanism.mirror, mechanism.copies)))
    for parameter in reversed(mechanism.parameters):  # which follow from those before them
        if parameter.name in named and parameter.value:
            named |= symbols(parameter.value)
    return named


def _names(value: object) -> Iterator[frozenset[str]]:
    """Yield the names in the formulas that a value holds, whatever it is."""
    if isinstance(value, Formula):
        yield symbols(value)
    elif isinstance(value, Mapping):
        yield from _names(tuple(value.values()))
    elif isinstance(value, (tuple, list)):
        for part in value:
            yield from _names(part)
    elif fields(value):
        yield from _names(tuple(contents(value, value).values()))
