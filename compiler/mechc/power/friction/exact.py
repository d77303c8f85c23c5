"""Friction by its exact equations: as many as there are pairs of surfaces.

With n the sizes of the pressing forces, n = |ideal + Σ D·n|. They are solved by Newton's
method along the way from D = 0, where n is what the loads press alone; loads are measured
by what they press altogether, so that the way has the same length however large they are.
"""

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import partial
from typing import NamedTuple

from ...algebra.angle import Rational
from ...algebra.product import ZERO, Product
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
from ...model.result import Definition, Result
from ..joint_forces import size_of
from ..speeds import even, magnitude
from .closed import Named, Printed, conditions, readable
from .pressing import Component, Pressed
from .rubs import Rub, radii, reduced
from .signs import AtOnePose, is_root
from .steps import Step


def first_order(
    ideal: Formula, pressed: Sequence[Pressed], sense: int, mechanism: Mechanism
) -> Named:
    """Return the driving load with the frictions that ideal pressing forces give.

    The power of friction with ideal instead of true forces: the error is of second order.
    """
    parts = _powers(pressed, partial(magnitude, mechanism=mechanism))
    return Named(_with(ideal, parts, sense))


def first_order_case(
    name: str, ideal: Result, pressed: Sequence[Pressed], sense: int, signs: AtOnePose
) -> Printed:
    """Return the same for the signs of a pose, and the forces and slips that it sums up."""
    parts = _powers(pressed, positive_at(signs))
    labels = radii(part.rub for part in parts)
    terms: list[Formula] = [Symbol(ideal.name)]
    forces: dict[Formula, Formula] = {}
    slips: dict[Formula, Formula] = {}
    for part in parts:
        factor = named_factor(part.rub, labels, signs).formula()
        force = _called(f"r_{part.rub.name}", part.force, forces, signs)
        slip = _called(_slip_name(part.rub), part.slip, slips, signs)
        terms.append(product([(number(sense), 1), (factor, 1), (force, 1), (slip, 1)]))
    equations = [(own, known) for told in (forces, slips) for own, known in told.items()]
    step = Step(
        "first order",
        equations=(*equations, (Symbol(name), total(terms))),
        defined=tuple(signs.definitions),
    )
    formula = _with(ideal.formula, parts, sense)
    return Printed(formula, (), conditions(signs), (step,))


def _called(name: str, size: Product, told: dict[Formula, Formula], signs: AtOnePose) -> Formula:
    """Return the name of a size, and note what it is: another of its kind where that is alike."""
    own, formula = Symbol(signs.fresh(name)), size.formula()
    told[own] = next((known for known, found in told.items() if found == formula), formula)
    return own


def positive_at(signs: AtOnePose) -> Callable[[Product], Product]:
    """Return what gives absolute values, by the signs of a pose."""
    return lambda value: value * signs.of("", value)


def _slip_name(rub: Rub) -> str:
    return f"{'Omega' if rub.bond.kind == 'pin' else 'v'}_{rub.name}"


def named_factor(rub: Rub, labels: Mapping[str, str], signs: AtOnePose) -> Product:
    """Return the factor of friction, the radius of a friction circle by its name."""
    if rub.name in labels:
        return signs.radius(labels[rub.name], rub.factor)
    return signs.coefficient(reduced(rub.name), rub.factor)


class Power(NamedTuple):
    """The power of one friction: the ideal force and the slip."""

    rub: Rub
    force: Product
    slip: Product

    @property
    def size(self) -> Product:
        """Return the power itself."""
        return self.rub.factor * self.force * self.slip


def _powers(pressed: Sequence[Pressed], positive: Callable[[Product], Product]) -> list[Power]:
    """Return the powers of frictions under ideal forces, but for those that are zero."""
    found = []
    for p in pressed:
        parts = [c.ideal for c in p.components if c.ideal]
        if parts and p.slip:
            x, y = (*parts, ZERO)[:2]
            force = size_of(x, y, positive) if y else positive(x)
            found.append(Power(p.rub, force, positive(p.slip)))
    return found


@frozen
class Sizes:
    """The names of the true sizes of pressing forces, by pair, and what they rest on."""

    names: Mapping[str, str]
    definitions: tuple[Definition, ...]
    sense: int

    @property
    def inside(self) -> frozenset[str]:
        """Return all names of the system, its many coefficients among them."""
        return frozenset(definition.name for definition in self.definitions)


def true_sizes(pressed: Sequence[Pressed], sense: int, taken: set[str]) -> Sizes:
    """Return the sizes of the pressing forces that solve the exact equations."""
    system = _Exact(pressed, sense, taken)
    names = {p.rub.name: name for p, name in zip(pressed, system.sizes, strict=True)}
    return Sizes(names, tuple(system.definitions()), sense)


def _with(ideal: Formula, parts: Sequence[Power], sense: int) -> Formula:
    """Return the driving load with the powers of friction added."""
    sizes = [even(p.size) for p in parts]
    alone = readable(add(s for s in sizes if not _has_root(s)))
    others = _gathered(s for s in sizes if _has_root(s))
    added = total([alone, *(size.formula() for size in others)])
    return total([ideal, added if sense > 0 else negative(added)])


def _has_root(value: Product) -> bool:
    return any(is_root(Product.of(factor)) for factor in value.factors)


def _gathered(terms: Iterable[Product]) -> list[Product]:
    """Return terms, those that differ by a number only in one."""
    numbers: dict[Product, Rational] = {}
    for term in terms:
        alike = Product(1, term.factors)
        numbers[alike] = numbers.get(alike, 0) + term.coefficient
    return [alike.scaled(size) for alike, size in numbers.items()]


def exact(
    ideal: Formula,
    pressed: Sequence[Pressed],
    sizes: Sizes,
    positive: Callable[[Product], Product],
) -> Named:
    """Return the driving load where every friction follows from its true pressing force.

    ``positive`` gives absolute values.
    """
    parts = [(p.rub, p.rub.factor.formula(), positive(p.slip).formula()) for p in pressed]
    steps = (Step("iterated"),)
    return Named(_sum(ideal, parts, sizes), sizes.definitions, steps=steps, inside=sizes.inside)


def exact_case(
    ideal: Formula, pressed: Sequence[Pressed], sizes: Sizes, signs: AtOnePose
) -> Printed:
    """Return the same with a name for each slip, its sign that of a pose."""
    labels, positive = radii(p.rub for p in pressed), positive_at(signs)
    parts = []
    for p in pressed:
        slip = Symbol(signs.define(_slip_name(p.rub), positive(p.slip).formula()))
        parts.append((p.rub, named_factor(p.rub, labels, signs).formula(), slip))
    where = (*signs.definitions, *sizes.definitions)
    steps = (Step("iterated"),)
    return Printed(_sum(ideal, parts, sizes), where, conditions(signs), steps)


def _sum(ideal: Formula, parts: Iterable[tuple[Rub, Formula, Formula]], sizes: Sizes) -> Formula:
    """Return the driving load with the powers of friction: factor, true size and slip of each."""
    sense = number(sizes.sense)
    added = (
        product([(sense, 1), (factor, 1), (Symbol(sizes.names[rub.name]), 1), (slip, 1)])
        for rub, factor, slip in parts
    )
    return total([ideal, *added])


NOTHING = number(Fraction(1, 10**30))
"""What stands beside pressing forces so that none of them vanishes, where no slope would be."""


def _size(components: Sequence[Formula]) -> Formula:
    if len(components) == 1:
        return Call("abs", (components[0],))
    return Call("hypot", (*components, NOTHING))


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
        ideal = (Symbol(row.ideal.name) for row in rows)
        yield Definition(self._scale, Call("hypot", (*ideal, NOTHING)))
        yield from (share for row in rows for _, share in row.shares)
        system, scale = self._system(pairs), Symbol(self._scale)
        names = {row.ideal.name for row in rows}
        arguments = tuple(
            quotient(Symbol(n), scale) if n in names else Symbol(n) for n, _ in system.anchor
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
