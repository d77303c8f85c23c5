"""Turns that are taken as radians: a speed of turning in Hz, a volume for each turn times it."""

from collections.abc import Iterator, Mapping

from ...diagnostics.model import sheets as messages
from ...syntax import ast
from ...units import DIMENSIONS, FREQUENCY, Dimension
from ..constants import expressions_in, leaves
from ..names.scope import Scope

TURNING = frozenset({"rpm", "rev/min", "rev/s", "rad/s", "deg/s", "°/s"})
"""Units of an angular velocity, in which an angle counts radians."""

TURNS = frozenset({"Hz", "1/s", "1/min"})
"""Units in which people count turns."""

SAID = frozenset({"rev", "rad"})
"""Units that say what is counted."""

FLOW = DIMENSIONS["volume"].over(DIMENSIONS["time"])

Line = ast.Param | ast.Let | ast.Taken


def note_turns(let: ast.Let, dimension: Dimension, lines: Mapping[str, Line], scope: Scope) -> None:
    """Note where a formula counts radians and its reader may count turns (W267, W268).

    It rests on a speed in rpm, says nowhere which of the two is meant, and is either such a speed
    shown in Hz or a flow made of a volume, which is that for a turn as catalogues have it.
    """
    assert let.value is not None
    if dimension not in (FREQUENCY, FLOW):
        return
    names = [leaf.name for leaf in _leaves(let) if isinstance(leaf, ast.Symbol)]
    units = _units(let, lines)
    if not units & TURNING or units & SAID:
        return
    shown = let.unit.text if let.unit else ""
    if dimension == FREQUENCY and shown in TURNS:
        scope.report.add(messages.turns_as_radians(let.unit.span if let.unit else let.span, shown))
    volumes = (n for n in names if _measures(n, DIMENSIONS["volume"], scope))
    if dimension == FLOW and (volume := next(volumes, "")):
        scope.report.add(messages.volume_of_a_radian(let.value.span, volume))


def _measures(name: str, dimension: Dimension, scope: Scope) -> bool:
    return name in scope.entries and scope.entries[name].dimension == dimension


def _units(line: Line, lines: Mapping[str, Line]) -> set[str]:
    """Return the units written in a line, and in those of what it rests on."""
    units, seen, waiting = set[str](), set[str](), [line]
    while waiting:
        line = waiting.pop()
        if isinstance(line, ast.Taken) or line.name.text in seen:
            continue
        seen.add(line.name.text)
        for leaf in _leaves(line):
            match leaf:
                case ast.Number(unit=unit):
                    units.add(unit)
                case ast.Symbol(name) if name in lines:
                    waiting.append(lines[name])
    return units


def _leaves(line: ast.Param | ast.Let) -> Iterator[ast.Symbol | ast.Number]:
    written = expressions_in(line.value) if line.value is not None else ()
    return (leaf for expression in written for leaf in leaves(expression))
