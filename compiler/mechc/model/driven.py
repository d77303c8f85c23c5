"""Whether the driving coordinate moves a mechanism, or is a size of its bodies."""

from collections.abc import Iterator

from ..diagnostics import Report
from ..diagnostics.model import doubts as messages
from ..formula.tree import Formula
from ..formula.walk import symbols
from ..frozen import replace
from ..units import LENGTH
from .entries import body_through, directions
from .mechanism import Absolute, Arrow, Mechanism, Offset, Turn
from .values import Chain, dependent


def checked(mechanism: Mechanism, report: Report) -> Mechanism:
    """Return the mechanism with what its drive is; remark on one that is no motion."""
    drive = mechanism.drive
    if drive is None:
        return mechanism
    driven = {drive.parameter}
    for name, formula in Chain(dependent(mechanism)).definitions:
        if not driven.isdisjoint(symbols(formula)):
            driven.add(name)
    if all(driven.isdisjoint(symbols(formula)) for formula in _moved(mechanism)):
        report.add(messages.drive_moves_nothing(drive.span, drive.parameter))
    parameters = [p for p in mechanism.parameters if p.name == drive.parameter]
    is_length = any(p.dimension == LENGTH for p in parameters)
    for entry in mechanism.geometry:
        sizes = [f for f in _sizes(entry, is_length) if not driven.isdisjoint(symbols(f))]
        if sizes and isinstance(entry, Arrow | Offset):
            body = body_through((entry.tail, entry.head), mechanism)
            if body:
                found = messages.drive_reshapes(
                    drive.span, drive.parameter, entry.tail, entry.head, body
                )
                report.add(found)
                return replace(mechanism, drive=replace(drive, reshapes=True))
    return mechanism


def _moved(mechanism: Mechanism) -> Iterator[Formula]:
    """Yield the formulas of all that makes the pose."""
    for entry in mechanism.geometry:
        match entry:
            case Arrow(length=length) if length is not None:
                yield length
            case Offset(x=x, y=y):
                yield from (x, y)
            case Turn(angle=angle):
                yield angle
    yield from (d.angle for d in directions(mechanism) if isinstance(d, Absolute))


def _sizes(entry: object, with_components: bool) -> Iterator[Formula]:
    """Yield the formulas of a vector's size; its components change with an angle, too."""
    match entry:
        case Arrow(length=length) if length is not None:
            yield length
        case Offset(x=x, y=y) if with_components:
            yield from (x, y)
