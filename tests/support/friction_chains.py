"""Chains whose friction is coupled."""

import re
from random import Random

from force_samples import Compiled
from mechc.compilation import Compilation
from mechc.source import Source

COUPLED = """\
mechanism m
param al = 60 deg in 0 deg .. 90 deg
pivot O
slider A along x
link OB
link ABC
OB = 100 mm @ al
BA = 80 mm @ 20 deg
BC = 60 mm @ 200 deg
force P at A along x
force F at C along 120 deg
friction pins 0.15 diameter 8 mm
find k = P/F
"""


def made_of(text: str) -> Compiled:
    compilation = Compilation(Source("sample.mech", text))
    return Compiled(compilation.tree, compilation)


def chain(seed: int) -> str:
    """Return two links with friction, all three angles over wide ranges."""
    dice = Random(seed)
    angles = [dice.uniform(0, 360) for _ in range(3)]
    wide = [dice.choice([40, 60, 90]) for _ in range(3)]
    names = [f"t{i}" for i in (1, 2, 3)]
    params = [
        f"param {n} = {a:.2f} deg in {a - w:.2f} deg .. {a + w:.2f} deg"
        for n, a, w in zip(names, angles, wide, strict=True)
    ]
    along, lengths = dice.uniform(0, 360), [dice.uniform(50, 150) for _ in range(3)]
    first, second = ("OB", "ABC") if dice.random() < 0.5 else ("AB", "OBC")
    load = ("BC" if second == "ABC" else "OC", "BA" if second == "ABC" else "AB")
    return "\n".join(
        [
            "mechanism chain",
            *params,
            f"pivot O\nslider A along {along:.2f} deg\nlink {first}\nlink {second}",
            f"{load[1]} = {lengths[0]:.1f} mm @ t1",
            f"OB = {lengths[1]:.1f} mm @ t2",
            f"{load[0]} = {lengths[2]:.1f} mm @ t3",
            f"force P at A along {along:.2f} deg",
            f"force F at C along {dice.uniform(0, 360):.2f} deg",
            f"friction pins {dice.uniform(0.05, 0.3):.3f} diameter {dice.uniform(4, 20):.1f} mm",
            f"friction slider A {dice.uniform(0.03, 0.3):.3f}",
            "find k = P/F",
        ]
    )


AS_GIVEN = re.compile(r"(-?\d+(?:\.\d+)?) deg(?! \.\.)")
"""A direction that is given, no end of a range."""


def squared(text: str, step: int) -> str:
    """Return a description whose directions as given are multiples of so many degrees.

    Slips are zero there, and what is computed of them is a rounding of either sign.
    """
    lines = (line.partition(" in ") for line in text.split("\n"))
    turned = ((_turned(head, step), between, ends) for head, between, ends in lines)
    return "\n".join(map("".join, turned))


def _turned(text: str, step: int) -> str:
    return AS_GIVEN.sub(lambda found: f"{step * round(float(found[1]) / step):g} deg", text)
