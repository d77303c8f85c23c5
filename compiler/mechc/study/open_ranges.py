"""Why loops have no pose at given values, and which ranges of parameters reach to such values."""

import math
from collections.abc import Mapping

from ..diagnostics import Report
from ..diagnostics import stroke as messages
from ..formula.continuation import continued
from ..formula.evaluate import status
from ..formula.tree import Formula, Implicit
from ..model.mechanism import Parameter
from ..model.values import Values, allowed, bounds, defaults, following
from ..pose.pose import Pose
from ..units import in_unit, si_unit

NOT_ASSEMBLED = "cannot be assembled"
NOT_FOUND = "iteration finds no pose"
NOT_REACHED = "no pose is reached from the default one"
NO_POSE = (NOT_ASSEMBLED, NOT_REACHED, NOT_FOUND)
"""From what is most surely known to what is least."""


def why_open(definitions: Mapping[str, Formula], values: Values) -> str:
    """Return why what loops define has no value, "" where all of it has one.

    Of the closures of a system one is followed, to its end: what rests on it may have a value
    in another one.
    """
    named = [(n, f) for n, f in definitions.items() if n in values]
    last = next((i for i, (n, _) in enumerate(named) if not math.isfinite(values[n])), None)
    if last is None:
        return ""
    broken = named[last][1]
    if isinstance(broken, Implicit) and status(broken, values) == 2:
        return NOT_FOUND
    is_followed = any(isinstance(f, Implicit) for _, f in named[: last + 1])
    return NOT_REACHED if is_followed else NOT_ASSEMBLED


RANGE_HALVINGS = 40
"""After so many nothing is left of a range that is shown."""


def remark(pose: Pose, report: Report) -> None:
    """Report W284 for each range at an end of which a loop does not close, the rest at default.

    The drive's is left to its stroke.
    """
    mechanism, drive = pose.mechanism, pose.mechanism.drive
    closing = _ClosedLoops(pose)
    if not closing.is_closed({}):
        return
    for parameter in mechanism.parameters:
        is_driven = drive is not None and drive.parameter == parameter.name and drive.low
        if parameter.range and parameter.value and not parameter.dependent and not is_driven:
            low, high = (_last(parameter, end, closing) for end in bounds(parameter))
            if low is not None or high is not None:
                below, above = _shown(low, parameter), _shown(high, parameter)
                why = closing.why(parameter, low is not None, high is not None)
                place, name = parameter.span, parameter.name
                report.add(messages.range_not_assembled(place, name, below, above, why))


class _ClosedLoops:
    """Whether the loops close at values of parameters, and the conditions of use hold."""

    def __init__(self, pose: Pose) -> None:
        self._pose = pose
        self._definitions: Mapping[str, Formula] = dict(pose.definitions)
        self._chain = following(pose.mechanism, pose.definitions, continued)
        self.defaults = defaults(pose.mechanism)
        self._given = {**dict.fromkeys(pose.placeholders, 1.0), **self.defaults}

    def is_closed(self, given: Values) -> bool:
        """Return whether there is a pose, or none that a condition of use allows.

        Where iteration finds none there may be one.
        """
        values = self._chain.complete({**self._given, **given})
        if why_open(self._definitions, values) in ("", NOT_FOUND):
            return True
        return not allowed(self._pose.mechanism, values)

    def why(self, parameter: Parameter, *ends: bool) -> str:
        """Return why a loop is open at ends of a range, of both what is known less surely."""
        open_at = (x for x, is_open in zip(bounds(parameter), ends, strict=True) if is_open)
        values = (self._chain.complete({**self._given, parameter.name: x}) for x in open_at)
        return max((why_open(self._definitions, v) for v in values), key=NO_POSE.index)


def _last(parameter: Parameter, end: float, closing: _ClosedLoops) -> float | None:
    """Return the value nearest to an end of a range at which the loops close; None at the end."""
    name, good, bad = parameter.name, closing.defaults[parameter.name], end
    if closing.is_closed({name: bad}):
        return None
    for _ in range(RANGE_HALVINGS):
        middle = (good + bad) / 2
        if closing.is_closed({name: middle}):
            good = middle
        else:
            bad = middle
    return good


def _shown(value: float | None, parameter: Parameter) -> str:
    unit = parameter.unit or si_unit(parameter.dimension)
    return "" if value is None else in_unit(value, unit, 6)
