"""The plan with its speeds as they follow from one another, where that is shorter.

To decide anything speeds are multiplied out and factored: then nothing is hidden in them. To be
read, a sum of two velocities is often better left as it stands.
"""

from collections.abc import Mapping

from ..algebra.product import Product
from ..algebra.sums import shortest
from ..frozen import fields, frozen
from .graph import Form
from .plan import Plan, Speeds


@frozen
class StandingPlan(Plan):
    """A plan to read formulas off: its speeds are divided by nothing that would cancel."""

    def value(self, form: Form) -> Speeds:
        """Return a linear form in the unknowns as one in the drives, as short as it can stand."""
        return tuple(
            shortest([size * self.speeds[u][i] for u, size in form.items()])
            for i in range(self.mobility)
        )


def standing(plan: Plan) -> StandingPlan:
    """Return the plan with speeds that single relations give as sums of those before."""
    speeds: dict[int, Speeds] = {drive: plan.speeds[drive] for drive in plan.drives}
    for relations, unknowns in plan.blocks:
        speeds |= {unknown: plan.speeds[unknown] for unknown in unknowns}
        if len(unknowns) == 1:
            form = plan.relations[relations[0]].form
            speeds[unknowns[0]] = _followed(form, unknowns[0], speeds)
    kept = {field.name: getattr(plan, field.name) for field in fields(plan)}
    return StandingPlan(**kept | {"speeds": speeds})


def _followed(form: Form, unknown: int, speeds: Mapping[int, Speeds]) -> Speeds:
    """Return the unknown of a relation by the speeds before it, or the form that it has."""

    def part(drive: int) -> Product:
        others = [-(p * speeds[u][drive] / form[unknown]) for u, p in form.items() if u != unknown]
        return shortest(others, speeds[unknown][drive])

    return tuple(part(drive) for drive in range(len(speeds[unknown])))
