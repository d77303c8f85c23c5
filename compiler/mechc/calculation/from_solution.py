"""What a sheet takes from a mechanism that it uses: results, and all that they rest on."""

from collections.abc import Iterator

from ..formula.walk import symbols
from ..frozen import replace
from ..model.mechanism import Parameter, Require, Subject
from ..model.result import Definition, Result, Solved
from ..pose.pose import Pose
from ..units import ANGLE


def solved(pose: Pose, results: tuple[Result, ...]) -> Solved:
    """Return the results, definitions and conditions of a mechanism, by its own names.

    Angles and lengths that no line gives but the drawing are numbers with names.
    """
    definitions = {d.name: Definition(*d) for d in pose.definitions}
    drawn = tuple(_drawn(pose))
    more = (Definition(d.name, d.value) for d in drawn if d.value and d.name not in definitions)
    return Solved(
        results,
        (*definitions.values(), *more),
        pose.loops,
        tuple(_of_the_pose(pose)),
        (*pose.mechanism.literals, *drawn),
    )


def _drawn(pose: Pose) -> Iterator[Parameter]:
    """Yield the angles and lengths of links that the drawing gives, and nothing drives."""
    for parameter in pose.mechanism.parameters:
        made_up = parameter.dependent and parameter.name.startswith(("phi_", "len_"))
        if made_up and parameter.value and not symbols(parameter.value):
            yield parameter


def _of_the_pose(pose: Pose) -> Iterator[Require]:
    """Yield the conditions on what is found by loops, which the sheet has no names for."""
    defined = {d.name for d in pose.definitions}
    for require in pose.mechanism.requires:
        if defined & (symbols(require.left) | symbols(require.right)):
            unit = "deg" if require.dimension == ANGLE else ""
            yield replace(require, subject=Subject("pose", "", ""), unit=unit)
