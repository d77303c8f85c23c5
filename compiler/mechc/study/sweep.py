"""Results where one parameter varies and the others stand at their values."""

import math
from collections.abc import Mapping, Sequence

from ..formula.rounding import Rounding, beyond_rounding
from ..formula.tree import Formula, is_call
from ..formula.walk import symbols
from ..kinematics.plan import Plan
from ..model.result import Result
from ..model.values import Chain, Values, allowed, compare, defaults, dependent

VALUE, LEFT, RIGHT = "=", "<", ">"
"""What a result's value, and the sides of its guards, are called, next to its definitions."""

SOON = 4
"""Code along a range is compiled when it has been used so often: most is used a hundred times."""


class Code:
    """The formulas of a pose and of results as code, the same whatever parameter varies."""

    def __init__(self, plan: Plan) -> None:
        pose = plan.graph.pose
        lets = {let.name: let.value for let in pose.mechanism.lets}
        self.formulas = {**dependent(pose.mechanism), **dict(pose.definitions), **lets}
        self.pose = Chain(self.formulas)
        self._closing = tuple(definition.name for definition in pose.definitions)
        self._forms: dict[tuple[int, frozenset[str]], tuple[Result, ResultCode]] = {}

    def closes(self, values: Values) -> bool:
        """Return whether loops close with values: nothing that closes them is undefined."""
        return not any(math.isnan(values.get(name, 0.0)) for name in self._closing)

    def of(self, result: Result, known: frozenset[str]) -> "ResultCode":
        """Return a result in names that have values in a pose."""
        key = id(result), known
        if key not in self._forms:
            self._forms[key] = result, ResultCode(result, known)
        return self._forms[key][1]


class ResultCode:
    """A result, with its definitions and the sides of its guards, in names that have values."""

    def __init__(self, result: Result, known: frozenset[str]) -> None:
        self._code = Chain(_formulas(result)).completion(known, SOON)
        places = {name: place for place, name in enumerate(self._code.names)}
        self._value = places.get(VALUE)
        guards = enumerate(guard.operator for guard in result.guards)
        sides = ((places.get(f"{LEFT}{i}"), sign, places.get(f"{RIGHT}{i}")) for i, sign in guards)
        self._guards = [(a, sign, b) for a, sign, b in sides if a is not None and b is not None]
        self._parts = [
            places[d.name] for d in result.where if d.name.startswith(VALUE) and d.name in places
        ]
        senses = (d.name for d in result.where if is_call(d.formula, "sense"))
        self._senses = [places[name] for name in senses if name in places]

    def following(self, values: Values) -> list[float]:
        """Return the values of the definitions, of the result and of the sides of its guards."""
        return self._code.following(values)

    def value(self, found: Sequence[float]) -> float:
        """Return the result's own value among them, NaN where it has none."""
        return math.nan if self._value is None else found[self._value]

    def guarded(self, found: Sequence[float]) -> float:
        """Return the result's own value, NaN as well where a guard does not hold."""
        sound = all(compare(found[i], sign, found[j]) for i, sign, j in self._guards)
        return self.value(found) if sound else math.nan

    def parts(self, found: Sequence[float]) -> tuple[float, ...]:
        """Return the values of the definitions that are called parts, as far as they have any."""
        return tuple(map(found.__getitem__, self._parts))

    def at_rest(self, found: Sequence[float]) -> int:
        """Return how many slips are 0, so that their friction has no sense."""
        return sum(found[i] == 0 for i in self._senses)

    def named(self, found: Sequence[float]) -> dict[str, float]:
        """Return all of them by name."""
        return dict(zip(self._code.names, found, strict=True))


class Sweep:
    """Evaluates results; ``loads`` are sizes of loads that nobody gives."""

    def __init__(
        self, plan: Plan, parameter: str, loads: Mapping[str, float], code: Code | None = None
    ) -> None:
        self._mechanism = plan.graph.pose.mechanism
        self._parameter = parameter
        self.defaults = {**loads, **defaults(self._mechanism)}
        self._code = code or Code(plan)
        self._known: dict[float, dict[str, float]] = {}
        self._found: dict[tuple[int, float], float] = {}
        self._sizes: dict[tuple[int, float], float | None] = {}
        self._rounding: dict[float, Rounding] = {}
        given = frozenset((*self.defaults, parameter))
        self._pose = self._code.pose.completion(given, SOON)
        self._names = given.union(self._pose.names)
        self._last: tuple[Result, float, ResultCode, list[float]] | None = None

    def values(self, x: float) -> dict[str, float]:
        """Return the values of all names that have one; nothing where no pose is allowed.

        Nor is there anything where a loop does not close, be it one that a result does not rest on.
        """
        if x not in self._known:
            values = self._pose.complete({**self.defaults, self._parameter: x})
            is_pose = self._code.closes(values) and allowed(self._mechanism, values)
            self._known[x] = values if is_pose else {}
        return self._known[x]

    @property
    def default(self) -> float:
        """Return the parameter's own value; any value where it is none of the mechanism."""
        return self.defaults.get(self._parameter, 0.0)

    def beyond_rounding(self, result: Result, x: float) -> float | None:
        """Return a result's value without what is nothing but rounding; None where it has none."""
        key = id(result), x
        if key not in self._sizes:
            number, rounding = self.of(result, x), self._rounding_at(x)
            size = beyond_rounding(number, result.formula, result.where, rounding)
            self._sizes[key] = size.number
        return self._sizes[key]

    def _rounding_at(self, x: float) -> Rounding:
        if x not in self._rounding:
            rounding = Rounding({**self.defaults, self._parameter: x})
            rounding.define(self._code.pose.definitions)
            self._rounding[x] = rounding
        return self._rounding[x]

    def varying(self, result: Result) -> set[str]:
        """Return the parameter and the names that vary with it, those of a result among them."""
        formulas = {**self._code.formulas, **dict(result.where)}
        needed = {name: symbols(formula) for name, formula in formulas.items()}
        varying, before = {self._parameter}, 0
        while len(varying) > before:
            before = len(varying)
            varying |= {n for n, needs in needed.items() if not varying.isdisjoint(needs)}
        return varying

    def of(self, result: Result, x: float) -> float:
        """Return a result's value, NaN where it has none."""
        key = id(result), x
        if key not in self._found:
            form, found = self._following(result, x)
            self._found[key] = form.value(found)
        return self._found[key]

    def guarded(self, result: Result, x: float) -> float:
        """Return a result's value, NaN as well where a guard of it does not hold."""
        form, found = self._following(result, x)
        return form.guarded(found)

    def at_rest(self, result: Result, x: float) -> int:
        """Return how many slips in a result are 0, so that their friction has no sense."""
        form, found = self._following(result, x)
        return form.at_rest(found)

    def parts(self, result: Result, x: float) -> tuple[float, ...]:
        """Return the values of the definitions of a result that are called parts."""
        form, found = self._following(result, x)
        return form.parts(found) if self.values(x) else ()

    def named(self, result: Result, x: float) -> dict[str, float]:
        """Return the values at ``x``, those of the names in a result among them."""
        form, found = self._following(result, x)
        return {**self.values(x), **form.named(found)}

    def _following(self, result: Result, x: float) -> tuple[ResultCode, list[float]]:
        """Return a result as code, and what it gives at ``x``; the last is kept."""
        if self._last and self._last[0] is result and self._last[1] == x:
            return self._last[2:]
        values = self.values(x)
        form = self._code.of(result, self._names if values else frozenset())
        found = form.following(values)
        self._last = result, x, form, found
        return form, found


def _formulas(result: Result) -> dict[str, Formula]:
    """Return a result's definitions, and with them its value and the sides of its guards."""
    found = {**dict(result.where), VALUE: result.formula}
    for i, guard in enumerate(result.guards):
        found |= {f"{LEFT}{i}": guard.left, f"{RIGHT}{i}": guard.right}
    return found
