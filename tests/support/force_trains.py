"""Random trains of gears, belts, racks and screws, for friction."""

from random import Random

from force_mechanisms import Growing, Sample


class Train(Growing):
    """A train while it grows: the wheel that turns last is on ``turning[-1]``."""

    def wheel(self) -> str:
        """Add a wheel on a pivot of its own, with a pin."""
        pivot, pin = self.pivot(), self.point()
        self.turning.append(self.link(pivot, pin))
        self.rods.pop()
        self.pins.append(pin)
        return pivot

    def radius(self) -> str:
        return f"{self.dice.uniform(15, 60):.1f} mm"

    def pair(self) -> None:
        """Gears or a belt to another wheel."""
        before, after = self.held[-1], self.wheel()
        kind, word = self.dice.choice(
            [("gear", ""), ("gear", " inner"), ("belt", ""), ("belt", " crossed")]
        )
        is_first = any(line.split()[1] == before for line in self.lines if "," in line)
        wheels = [after, before] if is_first or self.dice.random() < 0.5 else [before, after]
        sizes = ", ".join(f"{wheel} {self.radius()}" for wheel in wheels)
        self.lines.append(f"{kind} {sizes}{word}")

    def led(self) -> None:
        """A rack or a nut on a guide."""
        point, along = self.point(), self.angle()
        self.lines.append(f"slider {point} along {along}")
        size, sign = self.radius(), self.dice.choice(["", "-"])
        rack = f"rack {point} on {self.held[-1]} {sign}{size}"
        screw = f"screw {point} pitch {sign}{self.dice.uniform(2, 8):.1f} mm on {self.turning[-1]}"
        self.lines.append(self.dice.choice([rack, screw]))
        self.sliders[point] = along
        self.pins.append(point)


def train(seed: int) -> Sample:
    """Return a train: wheels, then a rack or a screw, then links, where there are any."""
    dice = Random(seed)
    growing = Train(dice)
    growing.wheel()
    growing.drive = dice.choice(
        [
            f"torque P on {growing.turning[0]}",
            f"force P at {growing.pins[0]} along {growing.angle()}",
        ]
    )
    for _ in range(dice.choice([0, 1, 2])):
        growing.pair()
    if len(growing.held) == 1 or dice.random() < 0.6:
        growing.led()
    for _ in range(dice.choice([0, 1])):
        dice.choice([growing.dyad, growing.rod_and_slider])()
    sizes = growing.load(True)
    return Sample("\n".join(growing.lines), "P", sizes, ())
