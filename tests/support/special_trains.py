"""Trains of special geometry: equal wheels, slots through a pivot, round angles, shared lengths.

A train grows from a lever by gears, belts, racks, screws, slots, cams, wedges and rods, each with
sizes and directions that are shared or round, of which formulas fall together and factors vanish.
Its pose is given by directions, so that nothing has to be closed.
"""

from random import Random

from friction_lines import friction_of

ROUND = (0, 90, 45, 180, -90, 135, 30, 60)
"""Directions in degrees at which a sine or a cosine vanishes, or two of them are equal."""


class Special:
    """A train while it grows: ``hub`` and ``pin`` are the pivot and the end of the last lever."""

    def __init__(self, dice: Random) -> None:
        self.dice = dice
        self._points = (f"{c}{n}" for n in ("", *range(1, 9)) for c in "ABCDEGHIJKLSUXYZ")
        self.lines = [
            f"param a = {dice.choice((50, 60, 100))} mm{self.ranged('20 mm .. 150 mm')}",
            f"param b = {dice.choice((60, 100))} mm{self.ranged('30 mm .. 200 mm')}",
            f"param r = {dice.choice((20, 25))} mm{self.ranged('10 mm .. 40 mm')}",
        ]
        for name in ("alpha", "be"):
            value = dice.choice((30, 45, 60, 20, 90, 120))
            low, high = value - dice.choice((20, 45, 60)), value + dice.choice((20, 45, 90))
            self.lines.append(
                f"param {name} = {value} deg{self.ranged(f'{low} deg .. {high} deg')}"
            )
        self.hub = self.pin = self.body = ""
        self.sliders: dict[str, str] = {}
        self.bodies: list[str] = []
        self.wheels: list[str] = []
        self.has_slot: set[str] = set()

    # -------------------------------------------------------------------- what is chosen

    def ranged(self, ends: str) -> str:
        return f" in {ends}" if self.dice.random() < 0.6 else ""

    def point(self) -> str:
        return next(self._points)

    def angle(self) -> str:
        """Return a direction: a round one, or one that others have as well."""
        turned = self.dice.choice(ROUND)
        shared = self.dice.choice(("alpha", "be", "-alpha", "alpha + be"))
        return self.dice.choice(
            (f"{turned} deg", f"{turned} deg", shared, shared, f"{turned} deg + {shared}")
        )

    def length(self) -> str:
        return self.dice.choice(("a", "a", "b", "2*a", "100 mm", "a + b"))

    def radius(self) -> str:
        return self.dice.choice(("r", "r", "r", "2*r", "25 mm"))

    def vector(self, tail: str, head: str, angle: str = "") -> None:
        self.lines.append(f"{tail}{head} = {self.length()} @ {angle or self.angle()}")

    # -------------------------------------------------------------------- parts

    def lever(self, pin: str = "") -> None:
        """A lever on a pivot of its own, to a pin that there is, or to a new one."""
        self.hub, self.pin = self.point(), pin or self.point()
        self.body = self.hub + self.pin
        self.lines += [f"pivot {self.hub}", f"link {self.body}"]
        self.bodies.append(self.body)
        self.vector(self.hub, self.pin)

    def wheel_pair(self) -> None:
        """Gears or a belt, often of equal wheels."""
        before = self.hub
        kind, word = self.dice.choice(
            (("gear", ""), ("gear", ""), ("gear", " inner"), ("belt", ""), ("belt", " crossed"))
        )
        self.lever()
        second = "3*r" if word == " inner" else self.radius()
        wheels = f"{before} {self.radius()}, {self.hub} {second}"
        if before in self.wheels:
            wheels = f"{self.hub} {second}, {before} {self.radius()}"
        self.wheels += [before, self.hub]
        self.lines.append(f"{kind} {wheels}{word}")

    def rod_and_lever(self) -> None:
        start, end = self.pin, self.point()
        self.lines.append(f"link {start}{end}")
        self.vector(start, end)
        self.lever(end)

    def rod_and_slider(self) -> None:
        start, self.pin, along = self.pin, self.point(), self.angle()
        self.lines += [f"slider {self.pin} along {along}", f"link {start}{self.pin}"]
        self.vector(start, self.pin)
        self.sliders[self.pin] = along

    def feed(self) -> None:
        """A rack or a nut on a guide, whose pitch may be a whole number or a multiple of π."""
        self.pin, along, sign = self.point(), self.angle(), self.dice.choice(("", "-"))
        pitch = self.dice.choice(("6 mm", "pi*r", "2*pi*r", "r/2"))
        rack = f"rack {self.pin} on {self.hub} {sign}{self.radius()}"
        screw = f"screw {self.pin} pitch {sign}{pitch} on {self.body}"
        self.lines += [f"slider {self.pin} along {along}", self.dice.choice((rack, screw))]
        self.sliders[self.pin] = along

    def slot(self) -> None:
        """A lever with a slot, whose line goes through its pivot or beside it."""
        pin, self.hub, out, far = self.pin, self.point(), self.point(), self.point()
        if pin in self.has_slot:
            return self.rod_and_lever()
        self.has_slot.add(pin)
        self.body, self.pin = f"{self.hub}{out}{far}", far
        angle = self.angle()
        line = f"{self.hub}{out}" if self.dice.random() < 0.7 else f"{out}{far}"
        self.lines += [f"pivot {self.hub}", f"link {self.body}", f"slot {pin} in {line}"]
        if line.startswith(out):  # the line leads from the pin's place on it, not from the pivot
            self.lines.append(f"{out}{pin} = a @ {out}{far}")
            self.vector(self.hub, out, angle)
            self.vector(out, far)
        else:
            self.vector(self.hub, pin, angle)
            self.vector(self.hub, far, self.dice.choice((angle, self.angle())))
        self.bodies.append(self.body)

    def arc(self) -> None:
        """A lever with a circular slot, of any centre."""
        pin, self.hub, middle, far = self.pin, self.point(), self.point(), self.point()
        if pin in self.has_slot:
            return self.rod_and_lever()
        self.has_slot.add(pin)
        self.body, self.pin = f"{self.hub}{middle}{far}", far
        size = self.length()
        self.lines += [
            f"pivot {self.hub}",
            f"link {self.body}",
            f"slot {pin} in {self.body} about {middle} radius {size}",
            f"{middle}{pin} = @ {self.angle()}",
        ]
        self.vector(self.hub, middle)
        self.vector(self.hub, far)
        self.bodies.append(self.body)

    def cam(self) -> None:
        """A lever on which a pin presses, along any normal."""
        pin = self.pin
        if pin in self.has_slot:
            return self.rod_and_lever()
        self.has_slot.add(pin)
        self.lever()
        self.lines.append(f"contact {pin} on {self.body} normal {self.angle()}")
        self.vector(self.hub, pin)

    def yoke(self) -> None:
        """A body that only translates, with a cross slot for the pin, or a face."""
        pin, near, far, along = self.pin, self.point(), self.point(), self.angle()
        if pin in self.has_slot:
            return self.rod_and_slider()
        self.has_slot.add(pin)
        self.lines.append(f"slide {near}{far} along {along}")
        if self.dice.random() < 0.6:
            self.lines += [f"slot {pin} in {near}{far}", f"{near}{far} = @ {self.angle()}"]
        else:
            self.lines.append(f"contact {pin} on {near}{far} normal {self.angle()}")
        self.pin = far

    def block(self) -> None:
        """A block on a rocker, fast in a link that slides along it."""
        pin, self.hub, far, out = self.pin, self.point(), self.point(), self.point()
        if pin in self.has_slot or not self.body.endswith(pin):
            return self.rod_and_lever()
        self.has_slot.add(pin)
        rocker, angle = f"{self.hub}{far}", self.angle()
        self.lines += [
            f"pivot {self.hub}",
            f"link {rocker}",
            f"link {pin}{out}",
            f"slot {pin} in {rocker} guiding {pin}{out}",
            f"{rocker} = 300 mm @ {angle}",
        ]
        self.vector(self.hub, pin, angle)
        self.vector(pin, out, self.dice.choice((f"perp {rocker}", rocker, f"-{rocker}")))
        self.body, self.pin = f"{pin}{out}", out

    def telescope(self) -> None:
        """A cylinder from a pivot to the pin, with a spring or the load in it."""
        start = self.point()
        self.lines += [f"pivot {start}", f"telescope {start}{self.pin}"]
        self.vector(start, self.pin)
        self.sliders[f"{start}{self.pin}"] = ""

    # -------------------------------------------------------------------- loads

    def drive(self) -> str:
        start = self.dice.choice(
            (
                f"torque P on {self.body}",
                f"torque P on {self.body}",
                f"force P at {self.pin} along {self.angle()}",
                f"force P at {self.pin} along perp {self.hub}{self.pin}",
            )
        )
        if self.dice.random() < 0.15:
            self.telescope()
            start = f"actuator P between {self.lines[-1].split()[0][0]} and {self.pin}"
        return start

    def load(self) -> list[str]:
        """Return the lines of what the train works against, and of what is asked for."""
        dice, along = self.dice, self.sliders.get(self.pin) or self.angle()
        last = f"{self.hub}{self.pin}"
        is_lever = last in self.bodies
        which = dice.random()
        if which < 0.65 or not is_lever:
            found = [f"force F at {self.pin} along {along}", "find k = P/F"]
        elif which < 0.75:
            found = [f"load F intensity q on {last} along {dice.choice(('-y', 'x', self.angle()))}"]
            found = ["param q = 2 N/mm", *found, "find k = P/F"]
        elif which < 0.85:
            found = [f"torque F on {last}", "find k = P/F"]
        elif which < 0.93:
            found = [f"weight F mass 2 kg at {self.pin}", "find P"]
        else:
            base = self.point()
            found = [f"pivot {base}", f"{base}{self.pin} = a @ {self.angle()}"]
            found += [
                f"spring 5 N/mm between {base} and {self.pin} free {dice.choice((40, 120))} mm"
            ]
            found += ["find P"]
        if dice.random() < 0.15:
            part = f"force T = {dice.choice(('0.5*F', '-F'))} at {self.pin} along {self.angle()}"
            found += [part] * (which < 0.75)
        return found

    def multiply(self) -> list[str]:
        """Return the lines that make it a half of a mirror, or one of copies, around a guide."""
        along = self.sliders.get(self.pin)
        if not along or self.dice.random() > 0.4:
            return []
        kind = self.dice.choice((f"mirror across {along}", "copies 3", "copies 2"))
        return [f"{kind} sharing {self.pin}"]


def special(seed: int) -> str:
    """Return a train of special geometry; ranges, loads and friction are there by chance."""
    dice = Random(f"special {seed}")
    if dice.random() < 0.1:
        return _brake(dice)
    train = Special(dice)
    train.lever()
    driving = train.drive()
    parts = [train.wheel_pair, train.wheel_pair, train.slot, train.slot, train.arc, train.block]
    parts += [train.rod_and_lever, train.cam, train.yoke]
    ends = [train.rod_and_slider, train.feed]
    for _ in range(dice.choice((0, 1, 1, 2))):
        if train.body.startswith(train.hub):
            dice.choice(parts)()
    if train.body.startswith(train.hub) and dice.random() < 0.5:
        dice.choice(ends)()
    lines = [*train.lines, driving, *train.load(), *train.multiply()]
    text = "\n".join(lines)
    if dice.random() < 0.4:
        text = "\n".join([text, "param q_f = 1", *_friction(text, dice)])
    return text + "\n"


def _brake(dice: Random) -> str:
    """A band brake of equal arms, or a shoe whose pivot is on the line of its friction."""
    wrap, mu = dice.choice((90, 180, 270, -90, -180, -270)), dice.choice((0.2, 0.25, 1))
    arms = dice.choice((("a", "a"), ("a", "2*a"), ("2*a", "a")))
    lines = [
        "param a = 50 mm in 20 mm .. 100 mm",
        f"param mu = {mu} in 0 .. 1",
        "pivot O\npivot C",
        "link OG",
        f"torque {dice.choice(('M', 'P'))} on OG",
    ]
    if dice.random() < 0.5:
        lines += [
            "link ACBH",
            f"CA = {arms[0]} @ {dice.choice((0, 180, 90))} deg",
            f"CB = {arms[1]} @ {dice.choice((0, 0, 90))} deg",
            "CH = 300 mm @ 0 deg\nOG = 100 mm @ 0 deg",
            f"rope A, O along y, B along {90 + wrap} deg",
            f"friction rope O mu wrap {wrap} deg drum 200 mm on OG",
        ]
    else:
        lines += [
            "link CTH",
            "OG = 100 mm @ 90 deg\nOT = 100 mm @ 90 deg",
            f"CT = ({dice.choice(('a', '2*a', '150 mm'))}, {dice.choice(('0 mm', '-a', 'a'))})",
            "CH = 300 mm @ 0 deg",
            "contact T on OG normal 90 deg",
            "friction contact T mu",
        ]
    lines += ["force N at H along -y", *["friction pins 0.1 diameter 20 mm"] * dice.randint(0, 1)]
    asked = "find M" if "torque M on OG" in lines else "find P"
    return "\n".join([*lines, asked, "find R_C", f"let N = {dice.choice((100, -100))} N"]) + "\n"


def _friction(text: str, dice: Random) -> list[str]:
    return [line.replace("*q", "*q_f") for line in friction_of(text, dice)]
