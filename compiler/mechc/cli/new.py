"""``mechc new``: a commented description to start from."""

from pathlib import Path

import click

from ..diagnostics import MechcError
from ..diagnostics.files import file_exists
from ..files import SUFFIXES, write_all
from ..source import Source
from .fmt import layout
from .session import Command
from .terminal import give, say

STARTER = """\
# A toggle clamp: the drive pushes the knee B, the ram K presses on the work.
# Change it to your mechanism, then:  mechc check {file}
mechanism {name} "Toggle clamp"
source "where the drawing comes from"

# What is known. A value makes the pose that is drawn; a range is what it may run over.
param l     = 200 mm                     # length of both links
param alpha = 10 deg in 2 deg .. 40 deg  # of each link from the line O-K

# What there is. Points are capital letters; links are named by their points.
pivot O                # a pin on the ground
slider K along 90 deg  # a point that the ground guides
link OB
link BK

# Where it is: length @ direction, counter-clockwise from +x.
OB = l @ 90 deg + alpha
BK = l @ 90 deg - alpha

# What acts on it, each force in the direction in which it acts on the mechanism.
force P at B along 0 deg    # the drive pushes the knee inwards
force F at K along -90 deg  # the work presses back

find k = P/F
# What the book says; `mechc check` proves it or shows where it is wrong.
expect k = 2*tan(alpha)
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
        give(starter(Path("mechanism_1.mech")))
        return
    path = Path(name) if Path(name).suffix in SUFFIXES else Path(f"{name}.mech")
    if not (path.stem.isidentifier() and path.stem.isascii()):
        raise click.BadParameter(
            f"{path.stem!r} is no name: letters, digits and _ make one", param_hint="NAME"
        )
    if path.exists():
        raise MechcError([file_exists(str(path))])
    write_all({path: starter(path)})
    say(path)


def starter(path: Path) -> str:
    """Return the example in the notation that the path's suffix says."""
    text = STARTER.format(name=path.stem, file=path.name)
    return layout(Source("starter.mech", text), "mech" if path.suffix == ".mech" else "yaml")
