"""A case to be solved: a result without friction, and the loads under which it is looked at."""

from collections.abc import Mapping

from ..algebra.product import Product
from ..model.result import Result
from ..named import NamedTuple


class Case(NamedTuple):
    """A result without friction: which load drives, by how much what is asked exceeds it."""

    ideal: Result
    driving: str
    factor: Product
    given: Mapping[str, Product]
