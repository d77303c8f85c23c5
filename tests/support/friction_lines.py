"""Lines of friction for a description, of every kind that its joints can have."""

from collections.abc import Iterator
from random import Random

WHEELS = ("gear", "belt", "rack", "screw")


def friction_of(text: str, dice: Random, said: bool = True) -> list[str]:
    """Return friction for all joints, by all its laws, each times ``q``.

    Where it matters in which link a pin is fast, that is ``said``, or left to be taken.
    """
    words = [line.replace(",", "").split() for line in text.splitlines()]
    links = [w[1] for w in words if w[0] == "link"]
    is_train = any(w[0] in WHEELS for w in words)
    found = list(_free_pins(words, links, dice)) if is_train else _pins(words, links, dice, said)
    carried = {p for link in links for p in points(link)}
    bodies = {p for w in words if w[0] == "slide" for p in points(w[1])}
    touching = [w for w in words if w[0] in ("slot", "contact")]
    for w in words:
        if w[0] == "slider" and w[1] in carried - bodies:
            found.append(_guide(w[1], dice))
        elif w[0] == "slide":
            found.append(f"friction slider {points(w[1])[-1]} 0.08*q")
        elif w[0] in ("slot", "contact") and [v[1] for v in touching].count(w[1]) == 1:
            found.append(f"friction contact {w[1]} {dice.uniform(0.03, 0.1):.3f}*q")
        elif w[0] == "screw":
            found.append(f"friction screw {w[1]} {dice.uniform(0.05, 0.15):.3f}*q thread 12 mm")
        elif w[0] in WHEELS:
            found.append(f"friction {w[0]} {w[1]} {dice.uniform(0.02, 0.08):.3f}*q")
    return found


def _pins(words: list[list[str]], links: list[str], dice: Random, said: bool) -> list[str]:
    """Return friction of all pins, and of some their own, fast in a link that is named."""
    law = dice.choice(["", " journal", " coulomb"])
    found = [f"friction pins {dice.uniform(0.05, 0.2):.3f}*q diameter 6 mm{law}"]
    often = [p for link in links for p in points(link)]
    pins = [p for p in dict.fromkeys(often) if often.count(p) > 1]
    chosen = dice.sample(pins, min(len(pins), dice.choice([0, 1, 2])))
    open_ = [p for p in pins if often.count(p) > 2 or _others(words, p)] if said else []
    for pin in dict.fromkeys((*chosen, *open_)):
        link = dice.choice([k for k in links if pin in points(k)])
        found.append(f"friction pin {pin} 0.15*q diameter 8 mm on {link}")
    return found


def _others(words: list[list[str]], pin: str) -> bool:
    """Tell whether anything but links acts on a pin."""
    loads = [w for w in words if w[0] in ("force", "weight", "actuator", "spring")]
    touches = [w for w in words if w[0] in ("slot", "contact")]
    return any(pin in w[2:] for w in loads) or any(pin == w[1] for w in touches)


def _free_pins(words: list[list[str]], links: list[str], dice: Random) -> Iterator[str]:
    """Yield friction of those pins that are not the pivots of wheels."""
    often = [p for link in links for p in points(link)]
    guided = {w[1] for w in words if w[0] == "slider"}
    pivots = {w[1] for w in words if w[0] == "pivot"}
    for pin in dict.fromkeys(often):
        if pin not in pivots and (often.count(pin) > 1 or pin in guided):
            carried = [k for k in links if pin in points(k)]
            matters = pin not in guided and (len(carried) > 2 or _others(words, pin))
            on = f" on {dice.choice(carried)}" if matters else ""
            yield f"friction pin {pin} {dice.uniform(0.05, 0.2):.3f}*q diameter 8 mm{on}"


def _guide(point: str, dice: Random) -> str:
    plunger = f"guide 50 mm overhang {dice.choice([5, 20, 35])} mm"
    laws = ["", f" {plunger}", f" {plunger} couple", f" {plunger} linear", f" {plunger} edges"]
    if dice.random() < 0.2:
        return f"friction roller {point} 0.1*q axle 8 mm wheel 25 mm"
    return f"friction slider {point} 0.08*q{dice.choice(laws)}"


def points(name: str) -> list[str]:
    """Split ``A1BC`` into its points."""
    found: list[str] = []
    for letter in name:
        if letter.isalpha():
            found.append(letter)
        else:
            found[-1] += letter
    return found
