"""What two mechanisms say of a point at which they are joined: the whole has the last word."""

from collections.abc import Iterable, Iterator, Mapping

from ...diagnostics import Report
from ...diagnostics import joining as messages
from ...syntax import ast
from .framed import angle_of

FRICTIONS = (ast.PinFriction, ast.GuideFriction, ast.RollerFriction)
"""Friction of which a point has one of a kind."""


class AtJoints:
    """What the whole says of points; ``joined`` are those of a part, by their names in it.

    The whole may speak of ``T.E`` by the name ``E2``, too: ``called`` has the one of the other.
    """

    def __init__(
        self,
        whole: Iterable[ast.Statement],
        joined: Mapping[str, str],
        called: Mapping[str, str],
    ) -> None:
        whole = tuple(whole)
        self._joined = joined
        self._placed = {
            s.point.text for s in whole if isinstance(s, ast.Pivot | ast.Drawn) and s.at
        }
        self._guides = {s.point.text: s for s in whole if isinstance(s, ast.Slider)}
        frictions = [s for s in whole if isinstance(s, FRICTIONS)]
        named = [(type(s), s.point.text) for s in frictions if s.point]
        self._frictions = {(kind, called.get(point, point)) for kind, point in named}
        self._has_pins = any(s.point is None for s in frictions)

    def has_friction(self, point: str) -> bool:
        """Return whether the whole says what friction the pin at a joined point has."""
        own = (ast.PinFriction, self._joined.get(point)) in self._frictions
        return own or (point in self._joined and self._has_pins)

    def left(
        self, statement: ast.Statement, there: ast.Statement, report: Report
    ) -> Iterator[ast.Statement]:
        """Yield the rest of a part's statement, if there is any.

        ``there`` is the statement as it would stand in the whole.
        """
        match statement, there:
            case ast.Pivot(point=point), ast.Pivot(point=name, at=at) if self._is_joined(point):
                if at and name.text not in self._placed:
                    yield ast.Drawn(there.span, name, at)
            case ast.Drawn(point=point), ast.Drawn(point=name) if self._is_joined(point):
                if name.text not in self._placed:
                    yield there
            case ast.Slider(point=point), ast.Slider(point=name) if name.text in self._guides:
                own = self._guides[name.text]
                if _angle(own.along) != _angle(there.along):
                    report.add(messages.guides_differ(own.span, name.text, statement.span))
            case _ if isinstance(there, FRICTIONS) and self._is_said(there):
                pass
            case _:
                yield there

    def _is_said(self, friction: ast.PinFriction | ast.GuideFriction | ast.RollerFriction) -> bool:
        point = friction.point
        return point is not None and (type(friction), point.text) in self._frictions

    def _is_joined(self, point: ast.Name) -> bool:
        return point.text in self._joined


def _angle(towards: ast.Direction) -> ast.Direction:
    return angle_of(towards) if isinstance(towards, ast.Axis) else towards
