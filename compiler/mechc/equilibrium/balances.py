"""Every sum that may be written for a free body: its moments about each point, its forces."""

from collections.abc import Iterable, Iterator

from ..algebra.angle import Angle
from ..algebra.product import ZERO, Product
from ..algebra.sums import add
from ..algebra.trigonometry import cosine, sine
from ..pose.pose import Vector, reverse
from .acts import Act, FreeBody
from .equilibrium import Balance, Terms


def balances(body: FreeBody) -> Iterator[Balance]:
    """Yield the sums of moments about each point of a body and of forces in each direction."""
    for centre, place in body.frame.items():
        moments = ((act.name, _moment(act, place)) for act in body.acts)
        yield Balance(body.name, _summed(moments), centre)
    for line in body.lines:
        terms = _summed((act.name, _part(act, line)) for act in body.acts)
        across = next((rod for name, rod in body.rods.items() if name not in terms), "")
        yield Balance(body.name, terms, "", line, line == body.guide, across)


def _summed(parts: Iterable[tuple[str, Product]]) -> Terms:
    """Return the coefficient of each force in a sum, those that vanish left out."""
    terms: dict[str, list[Product]] = {}
    for name, part in parts:
        terms.setdefault(name, []).append(part)
    sums = {name: add(there) for name, there in terms.items()}
    return {name: part for name, part in sums.items() if part}


def _moment(act: Act, centre: Vector) -> Product:
    """Return the moment of what acts about a point."""
    if act.along is None:
        return act.size
    arm = (*reverse(centre), *act.at)
    return act.size * add(length * sine(act.along - angle) for length, angle in arm)


def _part(act: Act, line: Angle) -> Product:
    """Return the component of what acts along a line."""
    return ZERO if act.along is None else act.size * cosine(act.along - line)
