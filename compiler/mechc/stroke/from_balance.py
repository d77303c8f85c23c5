"""From the results to the stroke."""

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import pairwise
from typing import Literal

from ..diagnostics import Report
from ..diagnostics import stroke as words
from ..formula.tree import Formula, degrees, number, product, total
from ..formula.walk import evaluate, symbols
from ..kinematics.plan import Plan
from ..model.mechanism import Drive, Link, LoadRatio, Mechanism, Parameter
from ..model.result import Result, Vanishing
from ..pose.pose import Pose
from ..power.balance import Balance
from ..units import ANGLE
from .along import Along
from .in_step import out_of_step
from .roots import Root, lowest, roots
from .stroke import Column, Extremum, Kind, Row, Singular, Stretch, Stroke
from .transmission import transmissions

SAMPLES = 720
"""Places at which the stroke is looked at for singular poses and extrema."""

KINDS: Mapping[int, Literal["minimum", "maximum"]] = {1: "minimum", -1: "maximum"}

SAME = 1e-9
"""A zero and a pole closer than this part of the stroke are one place: k is undetermined."""


def run(balance: Balance, results: Sequence[Result], points: int, report: Report) -> Stroke:
    """Return ``points`` rows along the stroke, and what is singular or extreme on it.

    Reports E591 without a drive, E592 without a stroke's ends, W591 where a link does not
    follow the drive.
    """
    pose = balance.plan.graph.pose
    drive = pose.mechanism.drive
    if drive is None:
        raise report.fail(words.no_drive(pose.mechanism.span, pose.free))
    parameter = next(p for p in pose.mechanism.parameters if p.name == drive.parameter)
    ends = _ends(drive, parameter)
    if ends is None:
        raise report.fail(words.no_stroke(drive.span, drive.parameter))
    runner = _Runner(pose, results, parameter, *ends)
    for link in runner.out_of_step(balance.plan):
        report.add(words.direction_stays(link.span, link.name, drive.parameter))
    return runner.stroke(points)


def _ends(drive: Drive, parameter: Parameter) -> tuple[float, float] | None:
    low, high = (
        (drive.low, drive.high) if drive.low and drive.high else parameter.range or (None, None)
    )
    if low is None or high is None:
        return None
    first, second = evaluate(low, {}), evaluate(high, {})
    return min(first, second), max(first, second)


class _Runner:
    """Runs along one stroke."""

    def __init__(
        self, pose: Pose, results: Sequence[Result], parameter: Parameter, low: float, high: float
    ) -> None:
        self._pose, self._parameter, self._low, self._high = pose, parameter, low, high
        self._along = Along(pose, _plain_lets(pose.mechanism))
        shown = [r for r in results if r.default is not None or r.target is not None]
        self._results = [r for r in shown if not self._is_open(r)]
        self._angles = list(dict.fromkeys(transmissions(pose)))

    def _is_open(self, result: Result) -> bool:
        """Tell a result that rests on loads whose size nobody gives."""
        loads = {load.name for load in self._pose.mechanism.loads}
        defined = {d.name for d in result.where}
        return bool((symbols(result.formula) & loads) - defined)

    def out_of_step(self, plan: Plan) -> Iterator[Link]:
        """Yield the links that do not follow the drive, as seen at its default."""
        middle = (self._low + self._high) / 2
        place = self._along.defaults.get(self._parameter.name, middle)
        return out_of_step(plan, self._along, place)

    def stroke(self, points: int) -> Stroke:
        """Return the whole."""
        places = _spaced(self._low, self._high, max(points - 1, 1))
        stretches = tuple(self._stretches())
        columns = [Column(r.name, r.dimension) for r in self._results]
        columns += [Column(f"mu_{t.pin}", ANGLE) for t in self._angles]
        singular = sorted(
            (s for st in stretches for s in self._singular(st)), key=lambda s: s.drive
        )
        extrema = sorted((e for st in stretches for e in self._extrema(st)), key=lambda e: e.drive)
        return Stroke(
            self._parameter.name,
            self._parameter.dimension,
            self._parameter.unit,
            self._low,
            self._high,
            tuple(columns),
            tuple(self._row(x) for x in places),
            stretches,
            tuple(_merged(singular, SAME * (self._high - self._low))),
            tuple(extrema),
            self._along.defaults,
        )

    def _row(self, place: float) -> Row:
        trouble = self._along.trouble(place)
        if trouble:
            return Row(place, (math.nan,) * (len(self._results) + len(self._angles)), trouble)
        values = [self._along.of(r.formula, r, place) for r in self._results]
        known = self._along.values(place)
        return Row(place, (*values, *(t.at(known) for t in self._angles)), "")

    def _stretches(self) -> Iterator[Stretch]:
        """Yield the parts of the stroke on which there is a pose, their ends to the last bit."""
        places = _spaced(self._low, self._high, SAMPLES)
        start, before = (places[0], "") if not self._along.trouble(places[0]) else (None, "")
        for a, b in pairwise(places):
            one, other = self._along.trouble(a), self._along.trouble(b)
            if one and not other:
                start, before = self._edge(a, b), one
            elif other and not one and start is not None:
                yield Stretch(start, self._edge(b, a), before, other)
                start = None
        if start is not None:
            yield Stretch(start, places[-1], before, "")

    def _edge(self, bad: float, good: float) -> float:
        while (middle := (bad + good) / 2) not in (bad, good):
            if self._along.trouble(middle):
                bad = middle
            else:
                good = middle
        return good

    # ------------------------------------------------------------------------ singular poses

    def _singular(self, stretch: Stretch) -> Iterator[Singular]:
        places = _spaced(stretch.low, stretch.high, SAMPLES)
        for result in self._results:
            if not isinstance(result.target, LoadRatio):
                continue
            for vanishing in result.zeros:
                yield from self._places(result, vanishing, "0", places, stretch)
            for vanishing in result.poles:
                yield from self._places(result, vanishing, "infinite", places, stretch)

    def _places(
        self,
        result: Result,
        vanishing: Vanishing,
        value: Literal["0", "infinite"],
        places: Sequence[float],
        stretch: Stretch,
    ) -> Iterator[Singular]:
        def factor(place: float) -> float:
            return self._along.of(vanishing.factor, result, place)

        found = [*roots(factor, places), *self._at_the_ends(factor, places, stretch)]
        for root in found:
            exact = self._exact(vanishing, root)
            yield Singular(result.name, value, vanishing.kind, *root, exact)

    def _at_the_ends(
        self, factor: Callable[[float], float], places: Sequence[float], stretch: Stretch
    ) -> Iterator[Root]:
        """Yield the ends beyond which nothing can be assembled, where the factor goes to zero.

        It does so as a square root, hence half the digits.
        """
        size = max(abs(factor(x)) for x in places)
        for end, why in ((stretch.low, stretch.before), (stretch.high, stretch.after)):
            if why and abs(factor(end)) < 1e-5 * size:
                yield Root(end, math.ulp(end))

    def _exact(self, vanishing: Vanishing, root: Root) -> Formula | None:
        """Return the drive as a constant formula, turned by half turns to the place found."""
        if vanishing.at is None or vanishing.at[0] != self._parameter.name:
            return None
        formula = vanishing.at[1]
        if symbols(formula) - self._along.defaults.keys():
            return None
        value = evaluate(formula, self._along.values(root.place))
        turns = round((root.place - value) / math.pi)
        shifted = total([formula, product([(number(turns), 1), (degrees(180), 1)])])
        return shifted if math.isclose(value + turns * math.pi, root.place, abs_tol=1e-9) else None

    # ------------------------------------------------------------------------------- extrema

    def _extrema(self, stretch: Stretch) -> Iterator[Extremum]:
        places = _spaced(stretch.low, stretch.high, SAMPLES)
        for result in self._results:
            values = [self._along.of(result.formula, result, x) for x in places]
            for i in range(1, len(places) - 1):
                before, here, after = values[i - 1 : i + 2]
                if before > here <= after or before < here >= after:
                    sense = 1 if here <= after else -1
                    place = self._turning(result, sense, places[i - 1], places[i + 1])
                    value = self._along.of(result.formula, result, place)
                    if math.isfinite(value) and sense * value <= sense * here:
                        kind = KINDS[sense]
                        yield Extremum(result.name, kind, place, value)

    def _turning(self, result: Result, sense: int, a: float, b: float) -> float:
        """Return the place between two others at which a result turns: where its slope is 0."""
        slope = (result.derivatives or {}).get(self._parameter.name)
        if slope is not None:
            found = roots(lambda x: self._along.of(slope, result, x), [a, b])
            if found:
                return found[0].place
        return lowest(lambda x: sense * self._along.of(result.formula, result, x), a, b)


def _place(found: Singular | Extremum) -> float:
    return found.drive


def _plain_lets(mechanism: Mechanism) -> dict[str, Formula]:
    """Return the user's formulas; those that rest on loads stay without a value."""
    return {let.name: let.value for let in mechanism.lets}


def _spaced(low: float, high: float, parts: int) -> list[float]:
    return [low + (high - low) * i / parts for i in range(parts)] + [high]


def _merged(found: Sequence[Singular], width: float) -> Iterator[Singular]:
    """Yield singular poses, a zero and a pole at one place as a branch point."""
    kept: list[Singular] = []
    for one in found:
        last = kept[-1] if kept else None
        if last and last.result == one.result and one.drive - last.drive <= width:
            if last.value != one.value:
                kind: Kind = "branch point"
                kept[-1] = last._replace(value="undetermined", kind=kind)
            continue
        kept.append(one)
    yield from kept
