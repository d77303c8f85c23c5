"""The plan with its speeds as they follow from one another, where that is shorter.

To decide anything speeds are multiplied out and factored: then nothing is hidden in them. To be
read, a sum of two velocities is often better left as it stands, and in a long chain each link's
speed under a name of its own.
"""

from collections.abc import Callable, Mapping, Sequence

from ..algebra.factors import Length
from ..algebra.matrices import shortest_determinant
from ..algebra.product import ZERO, Product
from ..algebra.sums import BoundSum, is_long, shortest
from ..base.frozen import fields, frozen
from ..formula.names import another
from .graph import LinearForm, Relation, SpeedKind
from .plan import Binding, Block, Plan, SpeedFactors

MOST_ORDERED_UNKNOWNS = 3
"""Unknowns of a block whose determinants are looked at in every order."""

Shortened = Callable[[int, SpeedFactors], SpeedFactors]
"""What is taken for the speed of an unknown by what follows from it."""


@frozen
class ReadablePlan(Plan):
    """A plan to read formulas off: its speeds are divided by nothing that would cancel."""

    def value(self, form: LinearForm) -> SpeedFactors:
        """Return a speed, linear in the unknowns, per unit of each drive, in its shortest form."""
        return tuple(
            shortest([size * self.speeds[u][i] for u, size in form.items()])
            for i in range(self.mobility)
        )


def readable_plan(plan: Plan) -> ReadablePlan:
    """Return the plan with speeds as they follow from those before."""
    return _plan_with(plan, _followed(plan, lambda unknown, found: found), {})


def in_ratios(
    plan: Plan, values: Mapping[str, float], taken: frozenset[str] = frozenset()
) -> ReadablePlan:
    """Return a plan of one drive in which every speed follows from named ratios.

    ``i_DEF`` is how fast link DEF turns, or point D moves along its guide, for a unit of the
    drive's speed; its sense is such that it is positive at ``values``. Of names that are
    ``taken`` it has none.
    """
    ratios = _NamedRatios(plan, values, taken)
    speeds = _followed(plan, ratios.name)
    return _plan_with(plan, speeds, ratios.found)


def _plan_with(
    plan: Plan, speeds: Mapping[int, SpeedFactors], ratios: Mapping[int, Binding]
) -> ReadablePlan:
    """Return a plan with other speeds, by ``ratios`` if there are any."""
    kept = {field.name: getattr(plan, field.name) for field in fields(plan)}
    if ratios:
        kept |= {"bindings": tuple(ratios.values()), "ratios": ratios}
    return ReadablePlan(**kept | {"speeds": speeds})


def _followed(plan: Plan, shortened: Shortened) -> Mapping[int, SpeedFactors]:
    """Return the speeds of a plan, block by block, each in those before it."""
    speeds: dict[int, SpeedFactors] = {drive: plan.speeds[drive] for drive in plan.drives}
    for block in plan.blocks:
        relations = [plan.relations[r] for r in block.relations]
        found = _block_speeds(plan, block, relations, speeds)
        speeds |= {u: shortened(u, s) for u, s in zip(block.unknowns, found, strict=True)}
    return speeds


def _block_speeds(
    plan: Plan, block: Block, relations: Sequence[Relation], speeds: Mapping[int, SpeedFactors]
) -> list[SpeedFactors]:
    """Return the unknowns of a block by the speeds before it, as multiplied out where short."""
    if len(relations) == 1:
        (unknown,) = block.unknowns
        return [_single(relations[0].form, unknown, speeds, plan.speeds[unknown])]
    whole = [plan.speeds[unknown] for unknown in block.unknowns]
    are_long = all(len(speed) == 1 and is_long(speed[0]) for speed in whole)
    if not are_long or len(relations) > MOST_ORDERED_UNKNOWNS:
        return whole
    return _by_determinants([r.form for r in relations], block.unknowns, speeds)


def _single(
    form: LinearForm, unknown: int, speeds: Mapping[int, SpeedFactors], whole: SpeedFactors
) -> SpeedFactors:
    """Return the unknown of a relation by the speeds before it, or the form that it has."""

    def part(drive: int) -> Product:
        others = [-(p * speeds[u][drive] / form[unknown]) for u, p in form.items() if u != unknown]
        return shortest(others, None if any(map(_has_names, others)) else whole[drive])

    return tuple(part(drive) for drive in range(len(whole)))


def _has_names(value: Product) -> bool:
    return any(isinstance(factor, BoundSum) for factor in value.factors)


def _by_determinants(
    forms: Sequence[LinearForm], unknowns: Sequence[int], speeds: Mapping[int, SpeedFactors]
) -> list[SpeedFactors]:
    """Return the unknowns of several relations by Cramer's rule, nothing being multiplied out."""
    matrix = [[form.get(u, ZERO) for u in unknowns] for form in forms]
    side = [
        shortest([-(p * speeds[u][0]) for u, p in form.items() if u not in unknowns])
        for form in forms
    ]
    whole = shortest_determinant(matrix)
    columns = range(len(unknowns))
    replaced = (
        [[*row[:c], s, *row[c + 1 :]] for row, s in zip(matrix, side, strict=True)] for c in columns
    )
    return [(shortest_determinant(rows) / whole,) for rows in replaced]


class _NamedRatios:
    """Names the speeds of links, and of points on their guides, for a unit of the drive's."""

    def __init__(self, plan: Plan, values: Mapping[str, float], taken: frozenset[str]) -> None:
        self._unknowns, self._values, self._taken = plan.graph.unknowns, dict(values), taken
        self.found: dict[int, Binding] = {}

    def name(self, unknown: int, speeds: SpeedFactors) -> SpeedFactors:
        """Name a speed and return it by that; a projection and a plain one remain as they are."""
        what, (speed,) = self._unknowns[unknown], speeds
        if what.kind is SpeedKind.COMPONENT or all(map(_is_plain, speed.factors)):
            return speeds
        name = self._free(f"i_{what.of}")
        sense = self._note(name, speed)
        ratio = BoundSum(name, speed.scaled(sense))
        self.found[unknown] = Binding(name, ratio.definition)
        return (Product(sense, {ratio: 1}),)

    def _free(self, name: str) -> str:
        while name in self._taken or any(b.name == name for b in self.found.values()):
            name = another(name)
        return name

    def _note(self, name: str, speed: Product) -> int:
        """Note the size of a speed at the values; return its sign, +1 where it has none."""
        try:
            value = speed.evaluate(self._values)
        except (KeyError, ZeroDivisionError):
            return 1
        self._values[name] = abs(value)
        return -1 if value < 0 else 1


def _is_plain(factor: object) -> bool:
    return isinstance(factor, Length | BoundSum)
