"""The driving load with friction, to first order and exactly, as a sum of powers.

Every friction adds its power, factor · pressing force · slip, to what the drive must do.
"""

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import partial

from ..algebra.angle import Rational
from ..algebra.from_formula import to_product
from ..algebra.product import ONE as UNIT
from ..algebra.product import ZERO, Product, Sum
from ..algebra.sums import add, canonical
from ..base.named import NamedTuple
from ..formula.operations import count_operations
from ..formula.tree import ONE, Formula, Symbol, negative, number, product, total
from ..formula.tree import ZERO as NONE
from ..model.mechanism import Mechanism
from ..model.result import Definition, Result
from ..power.joint_forces import size_of, size_of_two
from ..power.magnitudes import even, magnitude
from .closed_form import DefinedFormula, PrintedFormula, power, readable
from .friction_pairs import Component, FrictionPair, LoadedPair, radii, reduced
from .naming import ForceSizes
from .normal_forces import scaled
from .signs.at_one_pose import SignsAtOnePose
from .signs.conditions import conditions
from .signs.names import is_root
from .solution import FrictionStep


def first_order(
    ideal: Formula, loaded: Sequence[LoadedPair], sense: int, mechanism: Mechanism
) -> DefinedFormula:
    """Return the driving load with the frictions that ideal pressing forces give.

    The power of friction with ideal instead of true forces: the error is of second order.
    """
    parts = _powers(loaded, partial(magnitude, mechanism=mechanism))
    return DefinedFormula(_with(ideal, parts, sense))


def first_order_case(
    name: str, ideal: Result, loaded: Sequence[LoadedPair], sense: int, signs: SignsAtOnePose
) -> PrintedFormula:
    """Return the load of first order for the signs of a pose, with the forces and slips summed up.

    Where it is longer than these, they keep their names in it. What is zero at the pose adds
    nothing: a force and a slip that are would have one name, and another dimension each.
    """
    parts = [p for p in _powers(loaded, positive_at(signs)) if p.force and p.slip]
    formula = _with(ideal.formula, parts, sense)
    if count_operations(formula) > MOST_MULTIPLIED_OUT:
        return _in_names(ideal, parts, sense, signs)
    labels = radii(part.pair for part in parts)
    added: list[Added] = []
    forces: dict[Formula, Formula] = {}
    slips: dict[Formula, Formula] = {}
    for part in parts:
        factor = named_factor(part.pair, labels, signs).formula()
        force = _called(f"r_{part.pair.name}", part.force, forces, signs)
        slip = _slip_called(part.pair, part.slip, partial(_called, named=slips, signs=signs))
        added.append(Added(factor, force, slip, sense * part.times))
    equations = [*forces.items(), *slips.items()]
    step = FrictionStep(
        "first order",
        equations=(*equations, (Symbol(name), _sum(Symbol(ideal.name), added))),
        defined=tuple(signs.definitions),
    )
    return PrintedFormula(formula, (), conditions(signs), (step,))


def _in_names(
    ideal: Result, parts: Sequence["FrictionPower"], sense: int, signs: SignsAtOnePose
) -> PrintedFormula:
    """Return the load in the names of forces and slips, those that are alike under one."""
    labels = radii(part.pair for part in parts)

    def called(name: str, size: Product) -> Formula:
        formula = size.formula()
        same = formula == ideal.formula
        return Symbol(ideal.name if same else signs.define(name, formula))

    added = []
    for part in parts:
        factor = named_factor(part.pair, labels, signs).formula()
        force = called(f"r_{part.pair.name}", part.force)
        slip = _slip_called(part.pair, part.slip, called)
        added.append(Added(factor, force, slip, sense * part.times))
    where = (_called_so(ideal), *signs.definitions)
    return PrintedFormula(
        _sum(Symbol(ideal.name), added), where, conditions(signs), (FrictionStep("first order"),)
    )


MOST_MULTIPLIED_OUT = 60
"""Operations of a formula that is multiplied out: more are several lines, and names are read."""


SHORT_OPERATIONS = 12
"""Operations of a load without friction that may stand as a factor."""


def _called_so(ideal: Result) -> Definition:
    return Definition(ideal.name, ideal.formula)


def _called(
    name: str, size: Product, named: dict[Formula, Formula], signs: SignsAtOnePose
) -> Formula:
    """Return the name of a size, and note what it is: another of its kind where that is alike."""
    own, formula = Symbol(signs.fresh(name)), size.formula()
    named[own] = next((known for known, found in named.items() if found == formula), formula)
    return own


def positive_at(signs: SignsAtOnePose) -> Callable[[Product], Product]:
    """Return the function that gives absolute values, by the signs of a pose."""
    return lambda value: value * signs.note_sign("", value)


Naming = Callable[[str, Product], Formula]
"""Gives a size a name, and returns it; what is alike may have one already."""


def _slip_called(pair: FrictionPair, size: Product, called: Naming) -> Formula:
    """Return the name of a slip; one is no factor, as where a pin turns as much as the drive."""
    letter = "Omega" if pair.joint.kind == "pin" else "v"
    return ONE if size == UNIT else called(f"{letter}_{pair.name}", size)


def named_factor(pair: FrictionPair, labels: Mapping[str, str], signs: SignsAtOnePose) -> Product:
    """Return the factor of friction, the radius of a friction circle by its name."""
    if pair.name in labels:
        return signs.name_radius(labels[pair.name], pair.factor)
    return signs.name_coefficient(reduced(pair.name), pair.factor)


class FrictionPower(NamedTuple):
    """The power of one friction, and how often it is there: the ideal force and the slip."""

    pair: FrictionPair
    force: Product
    slip: Product
    times: Fraction

    @property
    def size(self) -> Product:
        """Return the power of all of them."""
        return (self.pair.factor * self.force * self.slip).scaled(self.times)


def _powers(
    loaded: Sequence[LoadedPair], positive: Callable[[Product], Product]
) -> list[FrictionPower]:
    """Return the powers of frictions under ideal forces, but for those that are zero."""
    found = []
    for p in loaded:
        parts = [c.ideal for c in p.components if c.ideal]
        if parts and p.slip:
            x, y = (*parts, ZERO)[:2]
            force = size_of(x, y, positive) if y else positive(x)
            found.append(FrictionPower(p.pair, force, positive(p.slip_of_one), p.times))
    return found


def _with(ideal: Formula, parts: Sequence[FrictionPower], sense: int) -> Formula:
    """Return the driving load with the powers of friction added."""
    sizes = [even(p.size) for p in parts]
    apart: dict[Product, list[Product]] = {}
    for part, size in zip(parts, sizes, strict=True):
        if not _has_root(size):
            apart.setdefault(part.pair.factor, []).append(size)
    alone = _added([size for together in apart.values() for size in together], [*apart.values()])
    others = _gathered(s for s in sizes if _has_root(s))
    added = total([alone, *(size.formula() for size in others)])
    whole = total([ideal, added if sense > 0 else negative(added)])
    return whole if others else min((whole, *_at_once(ideal, sizes, sense)), key=count_operations)


def _at_once(ideal: Formula, sizes: Sequence[Product], sense: int) -> Iterator[Formula]:
    """Yield a load without friction times a sum, if it is that: r(1 + c)/l, where teeth lose c."""
    if count_operations(ideal) <= SHORT_OPERATIONS:
        load = to_product(ideal)
        whole = add((load, *(size.scaled(sense) for size in sizes)))
        times = (whole / load).factors.items() if load else ()
        if load and all(isinstance(f, Sum) and exponent > 0 for f, exponent in times):
            yield readable(canonical(whole))


def _added(sizes: Sequence[Product], apart: Sequence[Sequence[Product]]) -> Formula:
    """Return a sum over one line, or those of each coefficient of friction apart where shorter.

    Coefficients of ropes, 2(e^(μθ) - 1)/(e^(μθ) + 1), would be multiplied out over one line.
    """
    ways = (readable(add(sizes)), total(readable(add(together)) for together in apart))
    return min(ways, key=count_operations)


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
    loaded: Sequence[LoadedPair],
    sizes: ForceSizes,
    positive: Callable[[Product], Product],
) -> DefinedFormula:
    """Return the driving load where every friction follows from its true pressing force.

    ``positive`` gives absolute values.
    """
    sense = Fraction(sizes.sense)
    parts = [
        Added(p.pair.factor.formula(), sizes.of(p.pair), positive(p.slip).formula(), sense)
        for p in loaded
    ]
    steps, whole = (step_of(loaded),), _sum(ideal, parts)
    return DefinedFormula(
        whole, sizes.definitions, sizes.positive, steps=steps, inside=sizes.inside
    )


def step_of(
    loaded: Sequence[LoadedPair], equations: Iterable[tuple[Formula, Formula]] = ()
) -> FrictionStep:
    """Return the step by which coupled equations are solved: of no pairs there are none.

    Of a single pair, whose friction no other changes, it has the name. ``equations`` are those
    that are short enough to be read.
    """
    if not loaded:
        return FrictionStep("unloaded")
    alone = loaded[0].pair.name if len(loaded) == 1 else ""
    return FrictionStep("iterated", alone, equations=tuple(equations))


def exact_case(
    ideal: Result,
    loaded: Sequence[LoadedPair],
    factor: Product,
    sizes: ForceSizes,
    signs: SignsAtOnePose,
) -> PrintedFormula:
    """Return the exact load with a name for each slip, its sign that of a pose.

    So has the load without friction, where it is long. A slip that is zero adds nothing. The load
    is ``factor`` times the one whose unit speed the slips are of.
    """
    labels, positive = radii(p.pair for p in loaded), positive_at(signs)

    def called(name: str, size: Product) -> Formula:
        return Symbol(signs.define(name, size.formula()))

    parts = []
    for p in scaled(loaded, factor):
        if size := positive(p.slip_of_one):
            slip = _slip_called(p.pair, size, called)
            named = named_factor(p.pair, labels, signs).formula()
            parts.append(Added(named, sizes.of(p.pair), slip, sizes.sense * p.times))
    is_long = count_operations(ideal.formula) > AS_SHORT_AS_NAME
    without, known = (Symbol(ideal.name), (_called_so(ideal),)) if is_long else (ideal.formula, ())
    where = (*known, *signs.definitions, *sizes.definitions)
    steps = (step_of(loaded, _equations(loaded, sizes, signs)),)
    return PrintedFormula(_sum(without, parts), where, conditions(signs), steps, sizes.positive)


LONGEST_EQUATIONS = 60
"""Operations of the coupled equations that are printed: those of four pins fill half a page."""


def _equations(
    loaded: Sequence[LoadedPair], sizes: ForceSizes, signs: SignsAtOnePose
) -> tuple[tuple[Formula, Formula], ...]:
    """Return n = |r + Dn| of each pair, by components; nothing if that is long.

    The signs are those of a pose. A pair that does not slip has no friction: its force is not
    asked for.
    """
    labels, frictions = radii(p.pair for p in loaded), {}
    for p in loaded:
        if against := signs.note_sign("", p.slip).scaled(-sizes.sense):
            factor = against * named_factor(p.pair, labels, signs)
            frictions[p.pair.name] = factor, sizes.of(p.pair)
    slipping = [p for p in loaded if p.pair.name in frictions]
    forces = [_size_under(frictions, p.components) for p in slipping]
    if sum(map(count_operations, forces)) > LONGEST_EQUATIONS:
        return ()
    return tuple(zip((sizes.of(p.pair) for p in slipping), forces, strict=True))


def _size_under(
    frictions: Mapping[str, tuple[Product, Formula]], components: Sequence[Component]
) -> Formula:
    """Return the size of a force, each friction by its factor and the force that presses there."""
    sides = []
    for component in components:
        made = (
            product([((part * frictions[name][0]).formula(), 1), (frictions[name][1], 1)])
            for name, part in component.by.items()
            if name in frictions
        )
        sides.append(total([component.ideal.formula(), *made]))
    x, y = (*sides, NONE)[:2]
    return size_of_two(x, y)


AS_SHORT_AS_NAME = 8
"""Operations of a formula without friction that is as short to read as its name."""


class Added(NamedTuple):
    """What a friction adds to the driving load: ``times`` factor · force · slip."""

    factor: Formula
    force: Formula
    slip: Formula
    times: Fraction


def _sum(ideal: Formula, parts: Iterable[Added]) -> Formula:
    """Return the driving load with the powers of friction, forces with one factor put together."""
    together: dict[tuple[Fraction, Formula, Formula], Counter[Formula]] = {}
    for part in parts:
        together.setdefault((part.times, part.factor, part.slip), Counter())[part.force] += 1
    added = (power(times, by, _counted(n), slip) for (times, by, slip), n in together.items())
    return total([ideal, *added])


def _counted(forces: Mapping[Formula, int]) -> Formula:
    """Return the sum of forces, each so many times."""
    return total(product([(number(times), 1), (force, 1)]) for force, times in forces.items())
