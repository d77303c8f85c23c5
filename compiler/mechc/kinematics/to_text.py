"""The plan as text, for ``mechc show kinematics``: unknowns, relations, their order, speeds."""

from collections.abc import Iterator, Sequence

from ..formula.to_text import text
from ..formula.tree import Formula, Symbol, product, total
from ..pose.to_text import angle_text
from .graph import Form, Kind, Relation, Unknown, Velocity
from .plan import Plan

_SENTENCES = {
    Kind.SPIN: "angular velocity of the link {of}, counter-clockwise",
    Kind.SLIDE: "speed of {of} along {direction}",
    Kind.COMPONENT: "velocity of {of} projected on {direction}",
}


def describe(plan: Plan) -> str:
    """Return the unknown speeds ``u0``, ``u1`` …, what relates them, and what they come to."""
    return "\n".join(_lines(plan)) + "\n"


def _lines(plan: Plan) -> Iterator[str]:
    drives = ", ".join(map(_name, plan.drives))
    yield f"mobility {plan.mobility}: {drives} taken as given"
    yield "unknown speeds"
    yield from (f"  {_name(i)}: {_unknown(u)}" for i, u in enumerate(plan.graph.unknowns))
    yield "velocities of the points"
    yield from (f"  {p}: {_velocity(v)}" for p, v in plan.graph.velocities.items())
    yield "relations"
    yield from (f"  {i}. {_relation(r)}" for i, r in enumerate(plan.relations))
    yield from (f"  redundant: {_relation(r)}" for r in plan.redundant)
    yield "order of solution"
    for block in plan.blocks:
        yield f"  {_listed(block.unknowns)} from {', '.join(map(str, block.relations))}"
    yield from _speeds(plan)


def _name(unknown: int) -> str:
    return f"u{unknown}"


def _listed(unknowns: Sequence[int]) -> str:
    return ", ".join(map(_name, unknowns))


def _unknown(unknown: Unknown) -> str:
    along = angle_text(unknown.direction) if unknown.direction is not None else ""
    return _SENTENCES[unknown.kind].format(of=unknown.of, direction=along)


def _velocity(velocity: Velocity) -> str:
    parts = [
        f"{text(_times(size.formula(), flow))} @ {angle_text(direction)}"
        for size, direction, flow in velocity
    ]
    return " + ".join(f"({part})" for part in parts) if len(parts) > 1 else "".join(parts) or "0"


def _times(factor: Formula, unknown: int) -> Formula:
    return product([(factor, 1), (Symbol(_name(unknown)), 1)])


def _relation(relation: Relation) -> str:
    along = angle_text(relation.along)
    points = ", ".join(relation.points)
    return (
        f"{form_text(relation.form)} = 0  ({relation.rule}, {relation.link}: {points}; on {along})"
    )


def form_text(form: Form) -> str:
    """Return a linear form in the unknowns."""
    return text(total(_times(size.formula(), u) for u, size in form.items()))


def _speeds(plan: Plan) -> Iterator[str]:
    yield "speeds"
    for binding in plan.bindings:
        yield f"  {binding.name} = {text(binding.value.formula())}"
    for unknown, speeds in sorted(plan.speeds.items()):
        if unknown not in plan.drives:
            form = dict(zip(plan.drives, speeds, strict=True))
            yield f"  {_name(unknown)} = {form_text({d: s for d, s in form.items() if s})}"
