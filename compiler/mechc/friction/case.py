"""A case to be solved: a result without friction, and the loads under which it is looked at."""

from collections.abc import Mapping

from ..algebra.product import ONE, Product
from ..algebra.sums import add, canonical
from ..model.mechanism import LoadForm, LoadRatio
from ..model.result import Result
from ..named import NamedTuple
from ..power.balance import Equations


class Case(NamedTuple):
    """A result without friction: which load drives, by how much what is asked exceeds it."""

    ideal: Result
    driving: str
    factor: Product
    given: Mapping[str, Product]


def case_of_loads(of: LoadRatio | LoadForm, ideal: Result, equations: Equations) -> Case:
    """Return the loads under which a ratio or a form of loads is looked at."""
    match of:
        case LoadRatio(above, below):
            upper, factor = equations.owner(above)
            lower, share = equations.owner(below)
            return Case(ideal, upper, factor, {lower: ONE / share})
        case LoadForm(load):
            return Case(ideal, load, ONE, _others(load, equations))


def case_of_force(driving: str, ideal: Result, equations: Equations) -> Case:
    """Return the loads under which a force at a joint is looked at: all of them."""
    return Case(ideal, driving, ONE, _others(driving, equations))


def _others(driving: str, equations: Equations) -> Mapping[str, Product]:
    """Return all other free loads as they are: one that does no work loads the joints, too."""
    names = (*equations.columns, *equations.idle_loads)
    return {n: Product.symbol(n) for n in names if n != driving}


def without_friction(case: Case, equations: Equations) -> Product:
    """Return the driving load that balances those given."""
    columns = equations.columns
    works = (columns[n][0] * size for n, size in case.given.items() if n in columns)
    return canonical(-(add(works) / columns[case.driving][0]))
