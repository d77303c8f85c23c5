"""Poses to check at: the default one, then feasible ones drawn from the parameters' ranges."""

import math
from collections.abc import Iterator, Mapping
from random import Random
from typing import Generic, TypeVar

from ..formula.evaluate import evaluate
from ..model.mechanism import Mechanism, Parameter, Require
from ..model.values import Chain, allowed, bounds, following, holds, user_defined
from ..pose.pose import Pose
from ..units import Dimension

Values = dict[str, float]

T = TypeVar("T")


class Replay(Generic[T]):
    """A stream of poses that can be gone through again from its start; each is drawn once."""

    def __init__(self, stream: Iterator[T]) -> None:
        self._stream = stream
        self._seen: list[T] = []

    def __iter__(self) -> Iterator[T]:
        yield from self._seen
        for pose in self._stream:
            self._seen.append(pose)
            yield pose


def candidates(pose: Pose, number: int) -> Iterator[Values]:
    """Yield the default pose, if it is feasible, and up to ``number`` random feasible ones.

    Where nothing varies there is no other pose. The draws depend on the mechanism's name only, so
    that every compile sees the same.
    """
    dice = Random(pose.mechanism.name)
    for turn in range(number + 1 if varies(pose) else 1):
        draw = _at_default if turn == 0 else _near
        parameters = {p.name: draw(p, dice) for p in _free(pose)}
        values = feasible_pose(pose, parameters, dice)
        if values is not None:
            yield values


def varies(pose: Pose) -> bool:
    """Return whether anything is free, so that there are other poses than the default one."""
    return bool(_free(pose)) or None in pose.placeholders.values()


def broken_at_default(pose: Pose) -> Require | None:
    """Return the first condition of use that the default pose breaks."""
    given = {p.name: evaluate(p.value, {}) for p in _free(pose) if p.value is not None}
    values = Chain(dict(pose.definitions)).complete(given)
    return next((r for r in pose.mechanism.requires if not holds(r, values)), None)


def feasible_pose(pose: Pose, parameters: Mapping[str, float], dice: Random) -> Values | None:
    """Return the values of all symbols at given parameters, None where there is no such pose.

    A made-up length that no loop fixes is drawn; no result may depend on it.
    """
    values = Chain(dict(pose.definitions)).complete(parameters)
    for name, length in pose.placeholders.items():
        values[name] = dice.uniform(0.5, 2) if length is None else length.evaluate(values)
    values = with_lets(pose.mechanism, values)
    finite = all(map(math.isfinite, values.values()))
    return values if finite and allowed(pose.mechanism, values) else None


def _free(pose: Pose) -> list[Parameter]:
    return [p for p in pose.mechanism.parameters if p.name in pose.free]


def _at_default(parameter: Parameter, dice: Random) -> float:
    if parameter.value is None:
        return _near(parameter, dice)
    return evaluate(parameter.value, {})


def _near(parameter: Parameter, dice: Random) -> float:
    return dice.uniform(*bounds(parameter))


def with_lets(mechanism: Mechanism, values: Mapping[str, float]) -> Values:
    """Return values with dependent parameters and lets; lets of results stay without a value."""
    return following(mechanism, user_defined(mechanism).items()).complete(values)


def free_values(pose: Pose, values: Mapping[str, float]) -> dict[str, tuple[float, Dimension]]:
    """Return the values of a pose's free parameters, with their dimensions, for messages."""
    free = (p for p in pose.mechanism.parameters if p.name in pose.free)
    return {p.name: (values[p.name], p.dimension) for p in free}
