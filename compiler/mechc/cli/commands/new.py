"""``mechc new``: a commented description to start from."""

import re
from pathlib import Path
from typing import Literal

from ...data_folders import data
from ...diagnostics import MechcError
from ...diagnostics.files import file_exists
from ...files import SUFFIXES, write_all
from ...source import Source
from .. import usage
from ..terminal import give, say
from .fmt import layout


@usage.command("new")
@usage.argument("name")
@usage.option("--toggle", "kind", value="toggle", default=True, help="A toggle clamp.")
@usage.option("--four-bar", "kind", value="four-bar", help="A four-bar linkage.")
@usage.option("--slider-crank", "kind", value="slider-crank", help="A slider-crank.")
@usage.option("--gripper", "kind", value="gripper", help="One half of a gripper.")
@usage.option("--cylinder", "kind", value="cylinder", help="A lever on a cylinder.")
@usage.option("--sheet", "kind", value="sheet", help="A calculation sheet.")
def command(name: str, kind: str) -> None:
    """Start a description from a commented example.

    NAME.mech is written, or NAME.yaml if NAME ends so; - prints to standard output.
    The example compiles as it is. The toggle clamp has angles for parameters; the
    others stand by the places of their pins, as a drawing has them. A calculation sheet
    has no links: it calculates whether a pin holds.

    \b
    mechc new clamp
    mechc new gripper.yaml --gripper
    """
    if name == "-":
        give(starter(Path("mechanism_1.mech"), kind))
        return
    path = Path(name) if Path(name).suffix in SUFFIXES else Path(f"{name}.mech")
    if not (path.stem.isidentifier() and path.stem.isascii()):
        raise usage.BadParameter(
            f"{path.stem!r} is no name: letters, digits and _ make one", where="NAME"
        )
    if path.exists():
        raise MechcError([file_exists(str(path))])
    write_all({path: starter(path, kind)})
    say(path)


_EXAMPLES: dict[str, dict[str, str]] = {
    "mech": {"USE": 'use "clamp.mech" as C (F = 2 kN)', "LET": "let F = C_R_O"},
    "yaml": {
        "USE": "use: {C: {name: clamp.yaml, with: {F: 2 kN}}}",
        "LET": "let: {F: C_R_O}",
    },
}
"""What comments of a starter propose, in both notations."""


def starter(path: Path, kind: str) -> str:
    """Return an example in the notation that the path's suffix says."""
    text = (data("cli") / "starters" / f"{kind}.mech").read_text("utf-8")
    named = re.sub(r"(?m)^(mechanism|sheet) \w+", rf"\1 {path.stem}", text)
    notation: Literal["mech", "yaml"] = "mech" if path.suffix == ".mech" else "yaml"
    for word, written in {"FILE": path.name, **_EXAMPLES[notation]}.items():
        named = named.replace(word, written)
    return layout(Source("starter.mech", named), notation)
