"""How what moves with the drive changes: along the drive, or in time where its speed is given.

The chain rule goes through the pose one definition at a time, each rate being a name of its
own, so that the formulas grow with the mechanism and no faster.
"""

from collections.abc import Iterable, Iterator, Mapping

from ..formula.derivative import derivative
from ..formula.tree import ZERO, Formula, Implicit, Symbol, product, total
from ..formula.walk import reached, symbols, walk
from ..model.values import Chain, dependent
from .pose import Pose, PoseDefinition


class NameRates:
    """The rates of names; those that are no number have a name and a definition themselves.

    ``unknown`` are the names of which nothing is known: a system's solution without slopes.
    """

    def __init__(self, rates: Mapping[str, Formula], unknown: Iterable[str] = ()) -> None:
        self.rates, self.unknown = dict(rates), set(unknown)
        self.named: dict[str, PoseDefinition] = {}

    def take(self, name: str, title: str, rate: Formula | None) -> None:
        """Enter the rate of a name under a title, None where it has no formula."""
        if rate is None:
            self.unknown.add(name)
        elif rate != ZERO:
            self.rates[name], self.named[name] = Symbol(title), PoseDefinition(title, rate)

    def of(self, formula: Formula) -> Formula | None:
        """Return the rate of a formula; None where it rests on what has none."""
        names = symbols(formula)
        moving = sorted(names & self.rates.keys())
        is_solved = any(isinstance(part, Implicit) for part in walk(formula))
        if not names.isdisjoint(self.unknown) or (moving and is_solved):
            return None
        parts = ((derivative(formula, name), self.rates[name]) for name in moving)
        return total(product([(part, 1), (rate, 1)]) for part, rate in parts)


class Titles:
    """Names of rates that are not taken: ``dpsi_dphi``, ``d2psi_dt2``."""

    def __init__(self, per: str, taken: Iterable[str]) -> None:
        self._per, self._taken = per, set(taken)

    def of(self, name: str, order: int = 1) -> str:
        """Return the name of a rate, the second one for an ``order`` of 2."""
        title = titled(name, self._per, order)
        while title in self._taken:
            title += "_"
        self._taken.add(title)
        return title


def titled(name: str, per: str, order: int = 1) -> str:
    """Return the name of a rate: ``dx_C_dphi``.

    >>> titled("psi", "t", 2)
    'd2psi_dt2'
    """
    power = "" if order == 1 else str(order)
    return f"d{power}{name}_d{per}{power}"


def first_rates(pose: Pose, speed: Formula, titles: Titles, wanted: Iterable[Formula]) -> NameRates:
    """Return the rates of all that formulas rest on where the drive has a speed."""
    assert pose.mechanism.drive is not None
    followed = dict(pose.closing) | dict(pose.definitions) | dependent(pose.mechanism)
    slopes = {n: slope.formula() for n, slope in pose.rates.items()}
    needed = reached(_symbols(wanted), {**followed, **slopes})
    rates = NameRates({pose.mechanism.drive.parameter: speed})
    for name, formula in Chain(followed).definitions:
        if name in needed:
            slope = slopes.get(name)
            rate = rates.of(formula) if slope is None else product([(slope, 1), (speed, 1)])
            rates.take(name, titles.of(name), rate)
    return rates


def second_rates(first: NameRates, titles: Titles) -> NameRates:
    """Return the rates of names and of their rates."""
    rates = NameRates(first.rates, first.unknown)
    for name, (title, formula) in first.named.items():
        rates.take(title, titles.of(name, 2), rates.of(formula))
    return rates


def _symbols(formulas: Iterable[Formula]) -> Iterator[str]:
    for formula in formulas:
        yield from symbols(formula)
