"""Every relation that a derivation prints, with numbers put in: speeds from coordinates.

The reading by coordinates shares nothing with the compiler, so a relation that holds
with its speeds is one that a person could check with a ruler on the drawing.
"""

import re
from fractions import Fraction

import numpy as np
import pytest

import reference_geometry
from good_mechanisms import ALL, compiled, tree_of
from mechc.formula.evaluate import evaluate
from mechc.formula.walk import symbols
from mechc.model.mechanism import Force
from mechc.power.numbers import default_values
from reference_geometry import assemble_half, points_of
from reference_kinematics import Motion


class Drawing:
    """One motion of a mechanism at its default pose: each symbol of a derivation as a number."""

    def __init__(self, name):
        self.balance = compiled(name).balance
        self.graph = self.balance.plan.graph
        self.mechanism = compiled(name).mechanism
        tree = tree_of(name)
        self.assembly = assemble_half(tree, reference_geometry.defaults(tree))
        self.motion = Motion(self.assembly)
        self.values = default_values(self.balance.plan)
        self.signed = self.balance.plan.mobility > 1
        self.unit = self._unit()

    def _unit(self):
        """Return a motion in which the first load that works does so with positive power."""
        mix = np.cos(np.arange(self.motion.basis.shape[1]))
        powers = [mix @ self.motion.power(a) for a in self.assembly.actions]
        sense = next((np.sign(p) for p in powers if abs(p) > 1e-9), 1.0)
        return mix if self.signed else mix * sense

    def velocity(self, point):
        return self.motion.velocity(point) @ self.motion.basis @ self.unit

    def component(self, point, angle):
        turn = angle.evaluate(self.values)
        return float(self.velocity(point) @ [np.cos(turn), np.sin(turn)])

    def symbol(self, name):
        """Return the value of a symbol of the derivation."""
        if name in self.values and not name.startswith("len_"):
            return self.values[name]
        kind, _, rest = name.partition("_")
        if kind == "len":
            return self.length(rest)
        if kind == "omega":
            return self.positive(float(self.motion.turning(rest) @ self.motion.basis @ self.unit))
        assert kind == "V", name
        return self.speed(*rest.split("_"))

    def speed(self, point, line=None):
        if line is None:
            (flow,) = self.graph.velocities[point]
            return self.positive(self.component(point, flow.direction))
        if line in self.balance.plan.graph.pose.lines:
            return self.component(point, self.graph.pose.lines[line])
        lines = {_line_of(u, self): u for u in self.graph.unknowns if u.of == point}
        return self.positive(self.component(point, lines[line].direction))

    def positive(self, speed):
        return speed if self.signed else abs(speed)

    def length(self, name):
        tail, head = points_of(name)
        for points in self.assembly.links.values():
            if {tail, head} <= points.keys():
                return abs(points[head] - points[tail])
        return self.assembly.lengths[tail, head]

    def sides(self, equation):
        named = symbols(equation.left) | symbols(equation.right)
        values = {name: self.symbol(name) for name in named}
        return evaluate(equation.left, values), evaluate(equation.right, values)


def _line_of(unknown, drawing):
    from mechc.report.derivation.notation import _name

    return re.sub(rf"^V_{unknown.of}_?", "", _name(unknown, drawing.balance.plan))


OPEN = re.compile(r"^ *(drive|use)\b|^param \w+:", re.MULTILINE)
"""Lines of what the reading by coordinates cannot draw: loops close, or values lack."""

DRAWN = [name for name, path in ALL.items() if not OPEN.search(path.read_text("utf-8"))]
every_drawing = pytest.mark.parametrize("name", DRAWN)


@every_drawing
def test_every_relation_holds(name):
    drawing = Drawing(name)
    for step in compiled(name).derivation.steps:
        for equation in (*step.relations, *step.results):
            left, right = drawing.sides(equation)
            assert left == pytest.approx(right, rel=1e-9, abs=1e-9), (step.rule, equation)


@every_drawing
def test_powers_are_those_of_the_drawing(name):
    """Each term of the power equation is count · load · speed, and the powers add up to zero."""
    drawing = Drawing(name)
    loads = {load.name: load for load in drawing.mechanism.loads}
    for term in compiled(name).derivation.terms:
        values = {s: drawing.symbol(s) for s in symbols(term.speed)}
        actions = (a for a in drawing.assembly.actions if a.name == term.load)
        power = sum(float(drawing.unit @ drawing.motion.power(a)) for a in actions)
        count = evaluate(term.times, {})
        found = count * evaluate(term.speed, values)
        assert count == times(loads[term.load], drawing.mechanism)
        assert found == pytest.approx(
            power * count / float(loads[term.load].times), rel=1e-9, abs=1e-9
        )


def times(load, mechanism):
    """Return how often a load acts: on each half or branch, unless it is on what they share."""
    points = (load.point,) if isinstance(load, Force) else points_of(load.link)
    number = Fraction(load.times)
    for group, count in ((mechanism.mirror, 2), (mechanism.copies, None)):
        if group and not set(points) <= set(group.sharing):
            number *= count or group.number
    return float(number)
