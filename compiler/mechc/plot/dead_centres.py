"""Which of the zeros and poles of a curve are dead centres."""

import math
from collections.abc import Callable, Iterable, Iterator, Mapping

from ..base.frozen import frozen, replace
from ..model.values import Chain, Values, defaults, following
from ..pose.pose import Pose
from ..study.analysis import Analysis, DeadCentre, Vanishing
from ..study.forms import form
from .plot import Curve, Plot

NEAR, ASIDE = 1e-12, 1e-3
"""How far from a point a factor is looked at, as parts of the range.

Rounding leaves it no value where the mechanism can just be assembled.
"""

NOTHING_NEARBY = 1e-4
"""What is smaller than this part of what a factor is near a point is nothing there."""


def with_dead_centres(plot: Plot, pose: Pose, results: Callable[[], Iterable[Analysis]]) -> Plot:
    """Return a plot whose curves have their dead centres; ``results`` are asked for if need be."""
    singular = {c.name for c in plot.curves if c.poles or any(m.kind == "zero" for m in c.marks)}
    if plot.equal or not singular:
        return plot
    named = {result.name: result for result in results() if result.name in singular}
    rest = _Rest(plot, defaults(pose.mechanism), following(pose.mechanism, pose.definitions), named)
    panels = (
        replace(panel, curves=tuple(replace(c, dead_centres=rest.of(c)) for c in panel.curves))
        for panel in plot.panels
    )
    return replace(plot, panels=tuple(panels))


@frozen
class _Rest:
    """What is needed to see whether something stands still at a point of a plot."""

    plot: Plot
    defaults: Values
    chain: Chain
    results: Mapping[str, Analysis]

    def of(self, curve: Curve) -> tuple[float, ...]:
        """Return the zeros and poles of a curve that are dead centres."""
        result = self.results.get(curve.name)
        if result is None:
            return ()
        zeros = [mark.at.x for mark in curve.marks if mark.kind == "zero"]
        pairs = [(x, result.zeros) for x in zeros] + [(x, result.poles) for x in curve.poles]
        return tuple(x for x, why in pairs if any(self._is_rest(x, curve, result, why)))

    def _is_rest(
        self, x: float, curve: Curve, result: Analysis, why: Iterable[Vanishing]
    ) -> Iterator[bool]:
        """Yield of each factor whether it vanishes at ``x`` since something stands still."""
        given = {**self.defaults, **{v.axis.name: v.value for v in curve.setting}}
        at, beside = (
            [self.chain.complete({**given, self.plot.varied.name: value}) for value in grid]
            for grid in self._around(x)
        )
        for vanishing in why:
            factor = form(vanishing.factor, result, at[0].keys())
            here, there = (
                [size for values in of if not math.isnan(size := abs(factor(values)))]
                for of in (at, beside)
            )
            is_nothing = bool(here and there) and min(here) < NOTHING_NEARBY * max(there)
            yield isinstance(vanishing.cause, DeadCentre) and is_nothing

    def _around(self, x: float) -> Iterator[list[float]]:
        """Yield ``x`` and those as near as rounding allows, then those next to it."""
        near, aside = (part * (self.plot.high - self.plot.low) for part in (NEAR, ASIDE))
        yield [x, x - near, x + near]
        yield [x - aside, x + aside]
