"""The symbols of velocities, and their sizes."""

from ..figure.tolerances import NO_SPEED
from ..figure.velocities import Velocities
from ..frozen import frozen
from .drawing import Run
from .lettering import measured, name


def index(*points: str) -> Run:
    """Return points as an index."""
    return Run("".join(run.text for point in points for run in name(point)), level=-1)


@frozen
class Speeds:
    """The velocities of one motion."""

    velocities: Velocities

    def name(self, *points: str) -> tuple[Run, ...]:
        """Return the symbol of a point's velocity, or of that relative to another point."""
        return Run("V", italic=True), index(*points)

    def spin_name(self, link: str) -> tuple[Run, ...]:
        """Return the symbol of a link's angular velocity."""
        return Run("ω", italic=True), index(link)

    def size(self, speed: float, *of: str) -> tuple[Run, ...]:
        """Return how large a speed is that depends on some points; nothing where that is open."""
        per = self.velocities.per
        if of == (per,) or not self.velocities.chosen.isdisjoint(of):
            return ()
        unit = self.name(per) if per else (Run("m/s", unit=True),)
        return (*measured(speed, of_another=bool(per)), *unit)

    def spin(self, link: str) -> tuple[Run, ...]:
        """Return the angular velocity of a link; nothing where that is open."""
        if link in self.velocities.chosen:
            return ()
        per, spin = self.velocities.per, self.velocities.spins[link]
        least = NO_SPEED * max(map(abs, self.velocities.spins.values()))
        if abs(spin) <= least:
            return (*self.spin_name(link), Run(" = 0"))
        unit = (*self.name(per), Run("/m", unit=True)) if per else (Run("rad/s", unit=True),)
        return (*self.spin_name(link), *measured(spin, of_another=bool(per)), *unit)
