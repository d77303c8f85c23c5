"""What the starter of a sheet says in its comment is followed as it stands."""

import re
from pathlib import Path

import pytest

import mechc
from mechc.cli.commands.new import starter

FINDS = {
    "mech": ("find k = P/F\n", "find k = P/F\nfind R_O\n"),
    "yaml": ("find:\n  k: P/F\n", "find: [k = P/F, R_O]\n"),
}


def following(text: str) -> str:
    """Return the sheet with its force taken from a mechanism, as its comment proposes."""
    use, let = re.findall(r"`((?:use|let)[^`]*)`", text)
    own = "\n".join(t for t in text.splitlines() if not re.match("param F |  F: ", t))
    if text.lstrip("# ").startswith("sheet ") or "\nsheet " in text:
        return f"{own}\n{use}\n{let}\n"
    inner = let.removeprefix("let: {").removesuffix("}")
    return own.replace("\nlet:\n", f"\n{use}\nlet:\n  {inner}\n") + "\n"


@pytest.mark.parametrize("notation", FINDS)
def test_the_force_on_the_pin_is_that_of_a_mechanism(tmp_path: Path, notation: str) -> None:
    clamp, pin = (tmp_path / f"{name}.{notation}" for name in ("clamp", "pin"))
    ratio, both = FINDS[notation]
    toggle = starter(clamp, "toggle")
    assert ratio in toggle
    clamp.write_text(toggle.replace(ratio, both), "utf-8")
    pin.write_text(following(starter(pin, "sheet")), "utf-8")
    sheet = mechc.load(pin).evaluate()
    # 2 kN on the ram: each link carries F/cos(alpha), at alpha = 10 deg.
    assert sheet["F"] == pytest.approx(2000 / 0.984807753012208)
    assert sheet["d"] == pytest.approx(0.008)
