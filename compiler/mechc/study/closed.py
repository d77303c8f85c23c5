"""Why loops have no pose at given values, and what of that is known."""

import math
from collections.abc import Mapping

from ..formula.evaluate import status
from ..formula.tree import Formula, Implicit
from ..model.values import Values

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
