"""What results are followed along: the drive and the angles that they depend on."""

from collections.abc import Iterator, Sequence

from ...formula.walk import evaluate, symbols
from ...model.locking import Range
from ...model.mechanism import Mechanism
from ...model.result import Result
from ...units import ANGLE, LENGTH


def varying(mechanism: Mechanism, results: Sequence[Result]) -> Iterator[str]:
    """Yield the drive and the angles that results depend on, in the order of the text."""
    used = _used(mechanism, results)
    drive = mechanism.drive.parameter if mechanism.drive else ""
    for parameter in mechanism.parameters:
        turns = parameter.dimension == ANGLE and not parameter.dependent
        if parameter.name in used and parameter.value and (turns or parameter.name == drive):
            yield parameter.name


def _used(mechanism: Mechanism, results: Sequence[Result]) -> set[str]:
    used: set[str] = set()
    for result in results:
        used |= symbols(result.formula).union(*(symbols(d.formula) for d in result.where))
    dependent = [p for p in mechanism.parameters if p.dependent and p.value]
    for _ in dependent:
        used |= {s for p in dependent if p.value and p.name in used for s in symbols(p.value)}
    return used


def range_of(name: str, mechanism: Mechanism) -> Range | None:
    """Return the drive's stroke, or a parameter's range, from its lower end."""
    drive = mechanism.drive
    ends = next(p.range for p in mechanism.parameters if p.name == name)
    if drive and drive.parameter == name and drive.low and drive.high:
        low, high = evaluate(drive.low, {}), evaluate(drive.high, {})
    elif ends is not None:
        low, high = (evaluate(end, {}) for end in ends)
    else:
        return None
    return (low, high) if low < high else (high, low)


def turns(name: str, mechanism: Mechanism) -> bool:
    """Tell whether a parameter is an angle."""
    return any(p.name == name and p.dimension == ANGLE for p in mechanism.parameters)


def unit_of(name: str, mechanism: Mechanism) -> str:
    """Return the unit of a length, "" for what is none."""
    parameter = next(p for p in mechanism.parameters if p.name == name)
    return (parameter.unit or "m") if parameter.dimension == LENGTH else ""
