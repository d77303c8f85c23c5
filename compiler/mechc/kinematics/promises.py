"""What a plan promises, as a check for tests and for whoever plans velocities."""

from collections import Counter
from collections.abc import Iterable, Iterator

from ..algebra.angle import QUARTER
from ..algebra.modular import ModularPoint
from ..algebra.product import ONE, ZERO, Product
from ..formula.walk import symbols
from ..pose.promises import known_names
from .forms import combined, projection, subtract
from .graph import LinearForm
from .plan import Plan


def broken_promises(plan: Plan) -> list[str]:
    """Return a sentence for each promise of this folder that a plan breaks."""
    order = [*_unknowns(plan), *_steps(plan)]
    return [*order, *_names(plan)] or [*_motions(plan)]


def _unknowns(plan: Plan) -> Iterator[str]:
    """Yield the faults of the speeds: each is a drive or in one block, and has its form."""
    count, mobility = len(plan.graph.unknowns), plan.mobility
    found = Counter([*plan.drives, *(u for block in plan.blocks for u in block.unknowns)])
    for unknown in range(count):
        if found[unknown] != 1:
            yield f"unknown {unknown} is found {found[unknown]} times"
        elif len(plan.speeds.get(unknown, ())) != mobility:
            yield f"unknown {unknown} has no part for each of {mobility} drives"
    for i, drive in enumerate(plan.drives):
        unit = tuple(ONE if i == j else ZERO for j in range(mobility))
        if plan.speeds.get(drive) != unit:
            yield f"the speed of drive {drive} is not its own unit"


def _steps(plan: Plan) -> Iterator[str]:
    """Yield the faults of the blocks: each is square and uses what is known before it."""
    used = Counter(r for block in plan.blocks for r in block.relations)
    for relation in range(len(plan.relations)):
        if used[relation] != 1:
            yield f"relation {relation} is used {used[relation]} times"
    known = set(plan.drives)
    for i, (relations, unknowns) in enumerate(plan.blocks):
        if len(relations) != len(unknowns):
            yield f"block {i} has {len(relations)} relations for {len(unknowns)} unknowns"
        known.update(unknowns)
        early = {u for r in relations for u in plan.relations[r].form} - known
        yield from (f"block {i} uses unknown {u} too early" for u in sorted(early))


def _names(plan: Plan) -> Iterator[str]:
    """Yield the names that speeds mention and nothing defines."""
    known = known_names(plan.graph.pose)
    for name, value in plan.bindings:
        if name in known:
            yield f"{name} means two things"
        yield from (f"{name} uses {n} too early" for n in sorted(_used([value]) - known))
        known.add(name)
    for unknown, speeds in plan.speeds.items():
        yield from (f"unknown {unknown} uses {n}" for n in sorted(_used(speeds) - known))


def _used(products: Iterable[Product]) -> frozenset[str]:
    return frozenset[str]().union(*(symbols(p.formula()) for p in products))


# -------------------------------------------------------- at a random point of a field


def _motions(plan: Plan) -> Iterator[str]:
    """Yield impossible motions: relations that fail, links that stretch, guides left."""
    point = ModularPoint()
    for relation in (*plan.relations, *plan.redundant):
        if _moves(plan, relation.form, point):
            what = f"{relation.link} {''.join(relation.points)}".strip()
            yield f"the {relation.rule} of {what} does not hold"
    for body, frame in plan.graph.pose.frames.items():
        first, *others = frame
        yield from (f"{body} stretches from {first} to {p}" for p in others
                    if _moves(plan, _stretching(plan, body, first, p), point))  # fmt: skip
    for guided, direction in plan.graph.pose.guides.items():
        across = projection(plan.graph.velocities[guided], direction + QUARTER)
        if _moves(plan, across, point):
            yield f"{guided} leaves its guide"
    for pivot in sorted(plan.graph.pose.mechanism.fixed):
        if plan.graph.velocities[pivot]:
            yield f"pivot {pivot} moves"


def _stretching(plan: Plan, body: str, tail: str, head: str) -> LinearForm:
    """Return (V_B − V_A)·AB, the rate of half the square of a distance."""
    velocities, parts = plan.graph.velocities, []
    for length, angle in plan.graph.pose.vector(body, tail, head):
        apart = subtract(projection(velocities[head], angle), projection(velocities[tail], angle))
        parts.append((length, apart))
    return combined(parts)


def _moves(plan: Plan, form: LinearForm, point: ModularPoint) -> bool:
    """Return whether a form in the unknowns is other than zero in some motion of the plan."""
    return any(_sum(plan, form, drive, point) for drive in range(plan.mobility))


def _sum(plan: Plan, form: LinearForm, drive: int, point: ModularPoint) -> int:
    parts = (p.residue(point) * plan.speeds[u][drive].residue(point) for u, p in form.items())
    return sum(parts) % point.prime
