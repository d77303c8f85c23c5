"""Friction by its exact equations: as many as there are pairs of surfaces.

With n the sizes of the pressing forces, n = |ideal + Σ D·n|. They are solved by Newton's
method along the way from D = 0, where n is what the loads press alone; loads are measured
by what they press altogether, so that the way has the same length however large they are.
"""

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from ...algebra.from_formula import to_product
from ...algebra.sums import add
from ...formula.tree import (
    Call,
    Formula,
    Implicit,
    Symbol,
    System,
    negative,
    number,
    product,
    quotient,
    total,
)
from ...frozen import frozen
from ...model.mechanism import Mechanism
from ...model.result import Definition
from ..joint_forces import size_of
from ..speeds import even, magnitude
from .closed import Named, readable
from .pressing import Component, Pressed


def first_order(
    ideal: Formula, pressed: Sequence[Pressed], sense: int, mechanism: Mechanism
) -> Named:
    """Return the driving load with the frictions that ideal pressing forces give.

    The power of friction with ideal instead of true forces: the error is of second order.
    """
    alone, paired = [], []
    for p in pressed:
        parts = [c.ideal for c in p.components if c.ideal]
        if len(parts) == 1:
            alone.append(p.rub.factor * magnitude(parts[0] * p.slip, mechanism))
        elif parts:
            x, y = parts
            size = to_product(size_of(x, y, mechanism))
            paired.append(even(p.rub.factor * size * magnitude(p.slip, mechanism)).formula())
    added = total([readable(add(alone)), *paired])
    return Named(total([ideal, added if sense > 0 else negative(added)]))


@frozen
class Sizes:
    """The names of the true sizes of pressing forces, by pair, and what they rest on."""

    names: Mapping[str, str]
    definitions: tuple[Definition, ...]
    sense: int


def true_sizes(pressed: Sequence[Pressed], sense: int, taken: set[str]) -> Sizes:
    """Return the sizes of the pressing forces that solve the exact equations."""
    system = _Exact(pressed, sense, taken)
    names = {p.rub.name: name for p, name in zip(pressed, system.sizes, strict=True)}
    return Sizes(names, tuple(system.definitions()), sense)


def exact(ideal: Formula, pressed: Sequence[Pressed], sizes: Sizes) -> Named:
    """Return the driving load where every friction follows from its true pressing force."""
    parts = [_added(p, Symbol(sizes.names[p.rub.name]), sizes.sense) for p in pressed]
    return Named(total([ideal, *parts]), sizes.definitions)


def _added(pressed: Pressed, size: Formula, sense: int) -> Formula:
    """Return what a friction adds to the driving load."""
    factor, slip = pressed.rub.factor.formula(), Call("abs", (pressed.slip.formula(),))
    return product([(number(sense), 1), (factor, 1), (size, 1), (slip, 1)])


def _size(components: Sequence[Formula]) -> Formula:
    if len(components) == 1:
        return Call("abs", (components[0],))
    return Call("hypot", tuple(components))


TOWARDS = (1.0, 0.37)
"""The components that every pressing force starts from: a direction that few ever have."""


class Row(NamedTuple):
    """One component of a pressing force: the ideal one, and its part per true size."""

    ideal: Definition
    towards: float
    shares: tuple[tuple[int, Definition], ...]

    def formula(self, sizes: Sequence[str]) -> Formula:
        """Return the component in the unknown sizes."""
        terms = (product([(Symbol(d.name), 1), (Symbol(sizes[i]), 1)]) for i, d in self.shares)
        return total([Symbol(self.ideal.name), *terms])


class _Exact:
    """Names what the system is made of, and the system."""

    def __init__(self, pressed: Sequence[Pressed], sense: int, taken: set[str]) -> None:
        self._pressed, self._sense, self._taken = pressed, sense, taken
        self._places = {p.rub.name: i for i, p in enumerate(pressed)}
        self.sizes = [self._name(f"n_{p.rub.name}") for p in pressed]
        self._unknowns = tuple(self._name(f"x_{p.rub.name}") for p in pressed)
        self._scale = self._name("n_0")

    def _name(self, wanted: str) -> str:
        while wanted in self._taken:
            wanted += "_"
        self._taken.add(wanted)
        return wanted

    def definitions(self) -> Iterator[Definition]:
        """Yield the ideal forces, how frictions change them, and the true sizes."""
        pairs = [self._rows(p) for p in self._pressed]
        rows = [row for pair in pairs for row in pair]
        yield from (row.ideal for row in rows)
        yield Definition(self._scale, Call("hypot", tuple(Symbol(r.ideal.name) for r in rows)))
        yield from (share for row in rows for _, share in row.shares)
        system, scale = self._system(pairs), Symbol(self._scale)
        ideal = {row.ideal.name for row in rows}
        arguments = tuple(
            quotient(Symbol(n), scale) if n in ideal else Symbol(n) for n, _ in system.anchor
        )
        for i, name in enumerate(self.sizes):
            found = Implicit(system, i, arguments)
            yield Definition(name, product([(scale, 1), (found, 1)]))

    def _rows(self, pressed: Pressed) -> list[Row]:
        return [
            Row(
                Definition(self._name(f"r_{pressed.rub.name}{axis}"), component.ideal.formula()),
                towards,
                tuple(self._shares(f"d_{pressed.rub.name}{axis}", component)),
            )
            for axis, towards, component in zip("xy", TOWARDS, pressed.components, strict=False)
        ]

    def _shares(self, prefix: str, component: Component) -> Iterator[tuple[int, Definition]]:
        """Yield by how much a unit of each true size changes a component."""
        for other, part in component.by.items():
            place = self._places[other]
            slip = self._pressed[place].slip
            factor = self._pressed[place].rub.factor
            against = product(
                [
                    (number(-self._sense), 1),
                    ((part * factor).formula(), 1),
                    (Call("sign", (slip.formula(),)), 1),
                ]
            )
            yield place, Definition(self._name(f"{prefix}{other}"), against)

    def _system(self, pairs: Sequence[Sequence[Row]]) -> System:
        equations = (
            total([Symbol(x), negative(_size([row.formula(self._unknowns) for row in pair]))])
            for x, pair in zip(self._unknowns, pairs, strict=True)
        )
        rows = [row for pair in pairs for row in pair]
        anchor = [(row.ideal.name, row.towards) for row in rows]
        anchor += [(share.name, 0.0) for row in rows for _, share in row.shares]
        start = (math.hypot(*(row.towards for row in pair)) for pair in pairs)
        return System(self._unknowns, tuple(equations), tuple(anchor), tuple(start))
