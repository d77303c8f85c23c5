"""``mechc new``: a commented description to start from."""

from pathlib import Path

import click

from ..diagnostics import MechcError
from ..diagnostics.files import file_exists
from ..files import SUFFIXES, write_all
from .session import Command

MECH = """\
# A toggle clamp: the drive pushes the knee B, the ram K presses on the work.
# Change it to your mechanism, then:  mechc check {name}.mech
mechanism {name} "Toggle clamp"
source "where the drawing comes from"

# What is known. A value makes the pose that is drawn; a range is what it may run over.
param l     = 200 mm                        # length of both links
param alpha =  10 deg  in 2 deg .. 40 deg   # of each link from the line O-K

# What there is. Points are capital letters; links are named by their points.
pivot  O                                    # a pin on the ground
slider K along 90 deg                       # a point that the ground guides
link   OB
link   BK

# Where it is: length @ direction, counter-clockwise from +x.
OB = l @ 90 deg + alpha
BK = l @ 90 deg - alpha

# What acts on it, each force in the direction in which it acts on the mechanism.
force P at B along 0 deg                    # the drive pushes the knee inwards
force F at K along -90 deg                  # the work presses back

find k = P / F

# What the book says; `mechc check` proves it or shows where it is wrong.
expect k = 2*tan(alpha)
"""

YAML = """\
# A toggle clamp: the drive pushes the knee B, the ram K presses on the work.
# Change it to your mechanism, then:  mechc check {name}.yaml
mechanism: {name}
title: Toggle clamp
source: where the drawing comes from

# What is known. A value makes the pose that is drawn; a range is what it may run over.
params:
  l: 200 mm                                 # length of both links
  alpha: {{value: 10 deg, range: 2 deg .. 40 deg}}  # of each link from the line O-K

# What there is. Points are capital letters; links are named by their points.
pivots: [O]                                 # a pin on the ground
sliders: {{K: 90 deg}}                        # a point that the ground guides
links: [OB, BK]

# Where it is: length @ direction, counter-clockwise from +x.
geometry:
  OB: l @ 90 deg + alpha
  BK: l @ 90 deg - alpha

# What acts on it, each force in the direction in which it acts on the mechanism.
forces:
  P: {{at: B, along: 0 deg}}                  # the drive pushes the knee inwards
  F: {{at: K, along: -90 deg}}                # the work presses back

find: {{k: P / F}}

# What the book says; `mechc check` proves it or shows where it is wrong.
expect:
  - k = 2*tan(alpha)
"""


@click.command("new", cls=Command)
@click.argument("name")
def command(name: str) -> None:
    """Start a description from a commented example.

    NAME.mech is written, or NAME.yaml if NAME ends so; - prints to standard output.
    The example compiles as it is.

    \b
    mechc new clamp
    mechc new clamp.yaml
    """
    if name == "-":
        click.echo(MECH.format(name="mechanism_1"), nl=False)
        return
    path = Path(name) if Path(name).suffix in SUFFIXES else Path(f"{name}.mech")
    if not (path.stem.isidentifier() and path.stem.isascii()):
        raise click.BadParameter(
            f"{path.stem!r} is no name: letters, digits and _ make one", param_hint="NAME"
        )
    if path.exists():
        raise MechcError([file_exists(str(path))])
    text = MECH if path.suffix == ".mech" else YAML
    write_all({path: text.format(name=path.stem)})
    click.echo(path)
