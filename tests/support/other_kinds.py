"""Random mechanisms of kinds that do not grow: ropes, bands, collars, wheels on arms, parts.

Each function returns the text of one; numbers have ranges, over which statements can be sampled.
"""

import re
from collections.abc import Callable
from pathlib import Path
from random import Random

from paths import EXAMPLES

PRESS = """
pivot O at ({x} mm, {y} mm)
link OA
link AB
OA = r @ phi
AB = {b} mm
drive phi from {low} deg to {high} deg
torque M on OA
use "toggle.mech" as T (l = {l} mm) at (0 mm, 210 mm) joining T.B = B
assembly ABC1 {side}
find k = M/T_F
"""
"""Joined with the toggle of the examples."""


def put_toggle(folder: Path) -> None:
    """Write the toggle of the examples, free to turn all the way, beside what joins it."""
    toggle = (EXAMPLES / "press" / "toggle.mech").read_text("utf-8")
    free = toggle.replace("in 2 deg .. 40 deg", "in -180 deg .. 180 deg")
    (folder / "toggle.mech").write_text(free, "utf-8")


def of_two_lengths(text: str, folder: Path) -> str:
    """Return a description whose toggle has links that are equally long by number only.

    The toggle is written beside it. Folded, its ram rests at the pivot from there on; where one
    parameter is the length of both it goes on.
    """
    put_toggle(folder)
    toggle = (folder / "toggle.mech").read_text("utf-8")
    own = toggle.replace("BK = l", "BK = m").replace("param alpha", "param m = 100 mm\nparam alpha")
    (folder / "toggle2.mech").write_text(own, "utf-8")
    text = text.replace('"toggle.mech"', '"toggle2.mech"')
    return re.sub(r"\(l = (.*?)\)", r"(l = \1, m = \1)", text)


def ranged(name: str, dice: Random, low: float, high: float, unit: str = "") -> str:
    """Return the line of a parameter whose range is a part of what it may be."""
    ends = sorted((dice.uniform(low, high), dice.uniform(low, high)))
    value = dice.uniform(*ends)
    return f"param {name} = {value:.4f} {unit} in {ends[0]:.4f} {unit} .. {ends[1]:.4f} {unit}"


def rope(dice: Random) -> str:
    """A hoist: blocks on fixed axles and a movable one, falls at an angle, a hand that pulls."""
    falls = dice.choice((1, 2, 3, 4))
    start = "K" if falls % 2 else "P0"
    stops, at = [], start
    for i in range(falls):
        at = "K" if at != "K" else f"P{i + 1}"
        slant = f" {dice.choice('+-')} u" if dice.random() < 0.5 else ""
        stops.append(f"{at} along {'-90' if at == 'K' else '90'} deg{slant}")
    hand = "-90 deg + t" if at != "K" else "90 deg + t"
    pivots = [
        f"pivot P{i}" for i in range(falls + 1) if any(f"P{i} " in s + " " for s in (*stops, start))
    ]
    straight = [s.split()[0] for s in stops[:-1] if s[0] == "P" and "u" not in "".join(stops)]
    with_friction = [f"friction rope {name} mu wrap 180 deg" for name in straight]
    lines = [ranged("t", dice, -80, 80, "deg"), ranged("u", dice, -40, 40, "deg")]
    if with_friction and dice.random() < 0.5:
        lines.append(ranged("mu", dice, 0.01, 0.6))
    else:
        with_friction = []
    lines += [*pivots, "slider K along y", f"slider H along {hand}"]
    lines += [f"rope {start}, {', '.join(stops)}, H along {hand}"]
    lines += [f"force P at H along {hand}", "force F at K along -y", *with_friction]
    return "\n".join([*lines, "find k = P/F"])


def band(dice: Random) -> str:
    """A band brake: a drum, and a lever that tightens the band at one of its ends or both."""
    lines = [
        ranged("D", dice, 100, 500, "mm"),
        ranged("a", dice, 50, 200, "mm"),
        ranged("l", dice, 200, 600, "mm"),
        ranged("mu", dice, 0.05, 0.5),
        "pivot O\npivot C",
        "link OG\nlink CAB",
        "OG = D/2 @ 90 deg",
        f"CA = a @ {dice.choice((0, 0, 180))} deg",
        "CB = l @ 0 deg",
        "rope C, O along x, A along -y",
        "torque M on OG",
        "force P at B along -y",
        "friction rope O mu wrap 270 deg drum D on OG",
        "find M",
    ]
    return "\n".join(lines)


def idle(dice: Random) -> str:
    """A drive that has friction alone to overcome: a drum, a slider, a band, a shoe."""
    return dice.choice((_idle_drum, _idle_slider, _gripping_band, _shoe))(dice)


def _idle_drum(dice: Random) -> str:
    """A drum on a pin, pressed into it by a load through its axis."""
    lines = [
        ranged("f", dice, 0, 0.5),
        ranged("t", dice, -180, 180, "deg"),
        "pivot O\nlink OA\nOA = 50 mm @ t",
        f"torque M on OA\nforce F at A along t + {dice.choice((0, 180))} deg",
        f"friction pins f diameter {dice.randint(8, 40)} mm",
        "find M\nfind R_O",
        f"let F = {dice.choice((300, -300))} N",
    ]
    return "\n".join(lines)


def _idle_slider(dice: Random) -> str:
    """A slider under a load across its guide, and a crank that follows."""
    way = dice.randint(-80, 80)
    lines = [
        ranged("mu", dice, 0, 0.9),
        ranged("f", dice, 0, 0.5),
        ranged("t", dice, 10, 170, "deg"),
        f"pivot O\nslider K along {way} deg\nlink OA\nlink AK",
        f"OA = 50 mm @ t\nAK = 120 mm @ {dice.randint(-40, 40)} deg",
        f"force P at K along {way} deg\nforce F at K along {way + dice.choice((90, -90))} deg",
        "friction slider K mu",
        *["friction pins f diameter 10 mm"] * dice.randint(0, 1),
        "find P",
        f"let F = {dice.choice((300, -300))} N",
    ]
    return "\n".join(lines)


def _gripping_band(dice: Random) -> str:
    """A band brake both ends of which are fast in the lever: one way round it may grip."""
    lines = [
        ranged("mu", dice, 0, 0.6),
        ranged("a", dice, 40, 120, "mm"),
        ranged("b", dice, 10, 39, "mm"),
        "pivot O at (0 mm, 0 mm)\npivot C at (0 mm, -250 mm)\nlink OG\nlink ACBH",
        "OG = 200 mm @ 0 deg\nCA = a @ 180 deg\nCB = b @ 0 deg\nCH = 350 mm @ 0 deg",
        "rope A, O along y, B along -y",
        "torque M on OG\nforce P at H along y",
        f"friction rope O mu wrap {dice.choice((180, -180))} deg drum 400 mm on OG",
        "find M\nfind R_C\nlet P = 300 N",
    ]
    return "\n".join(lines)


def _shoe(dice: Random) -> str:
    """A block brake: a lever presses a shoe onto a drum, which may grip one way round."""
    lines = [
        ranged("mu", dice, 0, 0.8),
        ranged("c", dice, -90, 90, "mm"),
        ranged("f", dice, 0.01, 0.4),
        "pivot O\npivot C\nlink OS\nlink CTH",
        "OS = 100 mm @ 90 deg\nOT = 100 mm @ 90 deg\nCT = (150 mm, -c)\nCH = 400 mm @ 0 deg",
        "contact T on OS normal 90 deg",
        "torque M on OS\nforce P at H along -y",
        "friction contact T mu",
        *["friction pins f diameter 20 mm"] * dice.randint(0, 1),
        "find M\nfind R_O\nlet P = 100 N",
    ]
    return "\n".join(lines)


def collar(dice: Random) -> str:
    """A screw with friction in its thread and at its collar."""
    kinds = ("mean d_c", "outer 2*d_c inner d_c", "outer 2*d_c inner d_c pressure")
    lines = [
        ranged("p", dice, 2, 30, "mm"),
        ranged("d", dice, 20, 60, "mm"),
        ranged("d_c", dice, 20, 80, "mm"),
        ranged("f", dice, 0.02, 0.3),
        ranged("f_c", dice, 0.02, 0.3),
        "pivot O\nlink OE\nOE = 10 mm @ 0 deg",
        "slider A along x",
        "screw A pitch p on OE",
        "torque T on OE",
        f"force F at A along {dice.choice(('-x', 'x', '20 deg'))}",
        "friction screw A f thread d",
        f"friction collar A f_c {dice.choice(kinds)}",
        "find k = T/F",
    ]
    return "\n".join(lines)


def arm(dice: Random) -> str:
    """Wheels on an arm: a sun, a planet, and a ring that stands, turns, or is left out."""
    ring = dice.choice(("", "on ground inner", "on ground inner"))
    lines = [
        ranged("r1", dice, 10, 60, "mm"),
        ranged("r2", dice, 10, 60, "mm"),
        "pivot O\nlink OA\nlink AB\nlink OS",
        f"{dice.choice(('gear', 'gear', 'belt'))} O r1 on {'OS' if ring else 'ground'}, A r2",
        "OA = (r1 + r2) @ t\nAB = 15 mm @ u\nOS = 10 mm @ 200 deg",
        ranged("t", dice, -180, 180, "deg"),
        ranged("u", dice, -180, 180, "deg"),
    ]
    if ring:
        lines.append(f"gear A r2, O r1 + 2*r2 {ring}")
        lines += [
            "torque M on OS",
            f"force F at {dice.choice('AB')} along {dice.randint(0, 359)} deg",
        ]
    else:
        lines = [
            line.replace("\nlink OS", "").replace("\nOS = 10 mm @ 200 deg", "") for line in lines
        ]
        lines += ["torque M on OA", f"force F at B along {dice.randint(0, 359)} deg"]
    return "\n".join([*lines, "find k = M/F"])


def choice(dice: Random) -> str:
    """A crank and its guide, whose lengths a choice, a table and a list of sizes give."""
    low = dice.uniform(-3, 1)
    lines = [
        ranged("v", dice, 0, 5),
        "table m = 0: 0.8, 2: 1.4, 5: 1.1",
        "list sizes = 80 mm, 120 mm, 200 mm, 400 mm",
        "let a = 50 mm when v < 2 else 30 mm when v < 3 else (40 mm + v*5 mm)",
        "let b = next 2*a in sizes",
        "let w = m at v",
        f"param phi = {low + 0.5:.4f} rad in {low:.4f} rad .. {low + 1:.4f} rad",
        "pivot O at (0 mm, 0 mm)\nslider B along x through O\nlink OA\nlink AB",
        "OA = a*w @ phi\nAB = b + 20 mm\nassembly B forward",
        f"drive phi from {low:.4f} rad to {low + 1:.4f} rad",
        "torque M on OA\nforce F at B along x",
        "find k = M/F",
    ]
    return "\n".join(lines)


def drives(dice: Random) -> str:
    """A five-bar with two drives, of which the first one moves."""
    t, u = dice.uniform(60, 150), dice.uniform(20, 110)
    lines = [
        f"param t = {t:.3f} deg in {t - 15:.3f} deg .. {t + 15:.3f} deg",
        f"param u = {u:.3f} deg in {u - 15:.3f} deg .. {u + 15:.3f} deg",
        "pivot O at (0 mm, 0 mm)\nlink OA\nlink AB\nOA = 50 mm @ t",
        f"drive t from {t - 10:.3f} deg to {t + 10:.3f} deg\ndrive u",
        f"force F at B along {dice.randint(0, 359)} deg",
        "find k = M/F" if dice.random() < 0.5 else "find V_B_x/omega_OA\nfind k = M/F",
    ]
    lines.append("pivot C at (100 mm, 0 mm)\nlink CD\nlink DB\nCD = 50 mm @ u")
    lines.append(f"AB = {dice.randint(70, 110)} mm\nDB = {dice.randint(70, 110)} mm")
    lines.append("assembly ABD cw\ntorque M on OA\ntorque T on CD")
    return "\n".join(lines)


def joined(dice: Random) -> str:
    """A crank joined with the toggle of the examples."""
    phi = dice.uniform(60, 150)
    text = PRESS.format(
        x=dice.randint(140, 180),
        y=dice.randint(80, 120),
        b=dice.randint(100, 150),
        l=dice.randint(95, 130),
        low=round(phi - 20),
        high=round(phi + 20),
        side=dice.choice(("cw", "ccw")),
    )
    r = ranged("r", dice, 15, 45, "mm")
    return f"{r}\nparam phi = {phi:.3f} deg in {phi - 20:.3f} deg .. {phi + 20:.3f} deg{text}"


KINDS: dict[str, Callable[[Random], str]] = {
    kind.__name__: kind for kind in (rope, band, idle, collar, arm, choice, drives, joined)
}
"""The kinds by their names."""


def other(kind: str, seed: int) -> str:
    """Return a random mechanism of a kind."""
    return KINDS[kind](Random(f"{kind} {seed}"))
