"""Driven mechanisms of special geometry: Cardan wheels, yokes, slots and arcs whose sizes agree.

A crank turns by the drive and wheels, feeds, slots, arcs and telescopes follow, so that along the
stroke pins pass over pivots, triangles fold, and slots become radial.
"""

from random import Random

AXES = ("x", "y", "-x", "-y", "45 deg", "30 deg")
STARTS = (30, 45, 60, 90, 120, 20, 135)


def driven(seed: int) -> str:
    """Return a mechanism with a drive; ranges, load and friction are there by chance."""
    dice = Random(f"special driven {seed}")
    family = dice.choice(FAMILIES)
    start = dice.choice((*STARTS, dice.randrange(5, 175)))
    low, high = start - dice.choice((5, 30, 60)), start + dice.choice((5, 45, 90))
    lines = [
        f"param a = {dice.choice((50, 60))} mm{_in(dice, '30 mm .. 80 mm')}",
        f"param b = {dice.choice((90, 120, 150))} mm{_in(dice, '85 mm .. 200 mm')}",
        f"param r = {dice.choice((20, 25))} mm",
        f"param phi = {start} deg{_in(dice, f'{low} deg .. {high} deg')}",
        f"drive phi from {low} deg to {high} deg",
        "pivot O at (0 mm, 0 mm)",
        *family(dice),
    ]
    return "\n".join(lines) + "\n"


def _in(dice: Random, ends: str) -> str:
    return f" in {ends}" if dice.random() < 0.3 else ""


def _load(dice: Random, point: str) -> list[str]:
    """Return a load at a point, the couple that drives, and what is asked for."""
    driving = ["torque M on OA", "find k = M/F"]
    return [f"force F at {point} along {dice.choice(AXES)}", *driving]


def _friction(dice: Random, *lines: str) -> list[str]:
    return [line for line in lines if line] if dice.random() < 0.4 else []


def _cardan(dice: Random) -> list[str]:
    """A wheel that rolls in a ring of twice its size: its rim draws straight lines."""
    ring = dice.choice(("2*r", "2*r", "3*r", "4*r"))
    turned = {"2*r": "-phi", "3*r": "-2*phi", "4*r": "-3*phi"}[ring]
    return [
        "link OA\nlink AB",
        f"OA = {ring} - r @ phi",
        f"AB = {dice.choice(('r', 'r', 'a', '2*r'))} @ {turned}{dice.choice(('', ' + 90 deg'))}",
        f"gear O {ring} on ground, A r inner",
        *_load(dice, "B"),
    ]


def _planet(dice: Random) -> list[str]:
    """Equal wheels outside one another: the planet turns twice as fast as its arm."""
    kind = dice.choice(("gear", "gear", "belt"))
    turned = "2*phi" if kind == "gear" else "0 deg"
    return [
        "link OA\nlink AB",
        "OA = 2*r @ phi" if kind == "gear" else "OA = a @ phi",
        f"AB = {dice.choice(('2*r', 'a', 'b'))} @ {turned}{dice.choice(('', ' + 90 deg'))}",
        f"{kind} O r on ground, A r",
        *_load(dice, "B"),
    ]


def _geared_slider(dice: Random) -> list[str]:
    """A wheel of the same size that works a slider crank of the same sizes."""
    return [
        "pivot Q at (2*r, 0 mm)\nlink OA\nlink QB\nlink BC",
        f"OA = a @ phi\nQB = a @ {dice.choice(('180 deg - phi', '-phi', '90 deg - phi'))}",
        f"BC = {dice.choice(('a', 'b', '2*a'))}",
        f"slider C along {dice.choice('xy')} through {dice.choice('OQ')}",
        "gear O r, Q r",
        f"assembly C {dice.choice(('forward', 'back'))}",
        *_friction(dice, "friction gear O 0.03", "friction slider C 0.1"),
        *_load(dice, "C"),
    ]


def _slot(dice: Random) -> list[str]:
    """A slotted lever whose pivot is as far away as the crank is long, or the crank's own."""
    place = dice.choice(("(a, 0 mm)", "(0 mm, -a)", "(b, 0 mm)", "(0 mm, -b)", "(-a, 0 mm)"))
    side = dice.choice(("QS", "perp QS", "-QS"))
    out = [f"QD = {dice.choice('ab')} @ {side}"]
    load = _load(dice, "D")
    if dice.random() < 0.4:
        out += [
            "link DE",
            "DE = b",
            f"slider E along {dice.choice('xy')} through {dice.choice('OQ')}",
        ]
        out += [f"assembly E {dice.choice(('forward', 'back'))}"]
        load = _load(dice, "E")
    return [
        f"pivot Q at {place}",
        "link OA\nlink QSD\nOA = a @ phi\nslot A in QS",
        f"assembly A {dice.choice(('forward', 'back'))}",
        *out,
        *_friction(dice, "friction contact A 0.1", "friction pins 0.1 diameter 8 mm"),
        *load,
    ]


def _arc(dice: Random) -> list[str]:
    """A circular slot as large as the crank, or about the pivot of its lever's length."""
    place = dice.choice(("(b, 0 mm)", "(a, a)", "(0 mm, -b)", "(2*a, 0 mm)"))
    return [
        f"pivot Q at {place}",
        "link OA\nlink QCD\nOA = a @ phi",
        f"QC = {dice.choice('ab')}",
        f"slot A in QCD about C radius {dice.choice('ab')}",
        f"QD = {dice.choice(('a', 'b'))} @ {dice.choice(('QC', 'perp QC', '-QC'))}",
        f"assembly ACQ {dice.choice(('cw', 'ccw'))}",
        *_friction(dice, "friction contact A 0.1"),
        *_load(dice, "D"),
    ]


def _yoke(dice: Random) -> list[str]:
    """A yoke with a cross slot, or a slanting one."""
    way = dice.choice((0, 90, 45))
    slant = way + dice.choice((90, 90, 60, -45))
    return [
        f"link OA\nslide XY along {way} deg\nslot A in XY\nOA = a @ phi\nXY = @ {slant} deg",
        *_friction(dice, "friction contact A 0.1", dice.choice(("friction slider Y 0.1", ""))),
        *_load(dice, "X"),
    ]


def _cylinder(dice: Random) -> list[str]:
    """A telescope between the crank and a pivot, which may be as far away as the crank is long."""
    place = dice.choice(("(a, 0 mm)", "(b, 0 mm)", "(0 mm, -b)", "(-a, a)", "(2*a, 0 mm)"))
    inside = dice.choice(
        (
            ["actuator N between Q and A", "torque M on OA", "find k = N/M"],
            ["spring 3 N/mm between Q and A free 60 mm", "torque M on OA", "find M"],
            ["actuator N between Q and A", "weight W mass 5 kg at A", "find N"],
        )
    )
    return [
        f"pivot Q at {place}\nlink OA\ntelescope QA\nOA = a @ phi",
        *_friction(dice, "friction pins 0.1 diameter 10 mm"),
        *inside,
    ]


def _toggle(dice: Random) -> list[str]:
    """Equal links, one half of a mirror or one of some copies, with loads of every kind."""
    many = dice.choice(
        ("mirror across 90 deg sharing K", "copies 3 sharing K", "copies 2 sharing K", "")
    )
    loads = dice.choice(
        (
            ["force M at A along x", "force F at K along -y", "find k = M/F"],
            ["torque M on OA", "force F at K along -y", "find k = M/F"],
            [
                "param q = 2 N/mm\nload F intensity q on OA along -y",
                "force M at K along y",
                "find k = M/F",
            ],
            ["force M at K along y", "weight W mass 3 kg at A", "find M"],
        )
    )
    return [
        f"link OA\nlink AK\nslider K along y through {dice.choice(('O', 'O', '(a, 0 mm)'))}",
        f"OA = a @ phi\nAK = {dice.choice(('a', 'a', 'b'))}",
        f"assembly K {dice.choice(('forward', 'back'))}",
        many,
        *_friction(
            dice, "friction pins 0.1 diameter 8 mm", dice.choice(("friction slider K 0.1", ""))
        ),
        *loads,
    ]


def _trammel(dice: Random) -> list[str]:
    """An ellipse trammel: a rod on crossed guides, as long as the crank that drives it."""
    return [
        "link OA\nlink BAC\nOA = a @ phi\nAB = a",
        f"AC = {dice.choice(('a', 'a', 'b', '2*a'))} @ BA",
        f"slider B along {dice.choice('xy')} through O\nassembly B forward",
        *_friction(dice, "friction pins 0.1 diameter 8 mm"),
        *_load(dice, "C"),
    ]


FAMILIES = (
    _cardan,
    _planet,
    _geared_slider,
    _slot,
    _slot,
    _arc,
    _arc,
    _yoke,
    _cylinder,
    _toggle,
    _trammel,
)
