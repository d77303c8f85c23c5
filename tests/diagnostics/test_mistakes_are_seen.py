"""One mistake put into a description of the library is never accepted in silence."""

import re
from collections.abc import Iterator
from random import Random

import pytest

from mechc.compilation import Compilation, complete
from mechc.diagnostics import MechcError, Report
from mechc.files import library
from mechc.source import Source
from mechc.syntax.notation import read
from mechc.syntax.to_yaml import to_yaml
from small_mechanisms import toggle
from sources import in_thirds

MISTAKEN = {"mm": "kg", "deg": "mm", "kg": "mm", "m": "deg", "N": "deg", "kN": "mm"}
QUANTITY = re.compile(r"(?<![\w.])(?!0 )(\d[\d.]*)\s+(mm|deg|kN|kg|N|m)(?![\w^/*])")
LINES = ("param", "OA", "AB", "OB", "BK", "slider", "force")


def mistakes(text: str) -> Iterator[tuple[str, str]]:
    """Yield descriptions with one mistake each, and what was done."""
    lines = text.splitlines()
    for number, line in enumerate(lines):
        code = line.split("#")[0].rstrip()
        for wrong in of_line(code):
            yield "\n".join([*lines[:number], wrong, *lines[number + 1 :], ""]), wrong


def of_line(code: str) -> Iterator[str]:
    if not code:
        return
    word = code.split()[0]
    yield code.replace(word, f"{word}x", 1)
    yield f"{code}\n{code}"
    if not word.startswith(LINES):
        return
    for found in QUANTITY.finditer(code):
        start, end = found.span(2)
        yield f"{code[:start].rstrip()}{code[end:]}"
        yield f"{code[:start]}{MISTAKEN[found[2]]}{code[end:]}"


def is_seen(text: str) -> bool:
    """Return whether a mistake is stated, with a hint."""
    compilation = Compilation(Source("a.mech", text))
    try:
        found = compilation.balance and compilation.report.diagnostics
    except MechcError as error:
        found = error.diagnostics
    assert all(diagnostic.hint for diagnostic in found), text
    return bool(found)


def drawn(seed: int, number: int) -> list[tuple[str, str, str]]:
    dice = Random(seed)
    texts = {name: path.read_text("utf-8") for name, path in library().items()}
    every = [(name, text, wrong) for name in texts for text, wrong in mistakes(texts[name])]
    return dice.sample(every, number)


def silent(cases: list[tuple[str, str, str]]) -> list[tuple[str, str]]:
    return [(name, wrong) for name, text, wrong in cases if not is_seen(text)]


TOGGLE = toggle(
    "find k = P/F",
    "expect k = 2*tan(alpha)",
    "expect k = 0.353 at alpha = 10 deg",
    alpha="10 deg in 2 deg .. 40 deg",
)

KINDS = (
    # an angle
    ("crank_rocker", "phi = 60 deg", "phi = 60 rad", "W245"),
    ("crank_rocker", "in 0 deg .. 360 deg", "in 0 deg .. 3600 deg", "W245"),
    ("crank_rocker", "to 360 deg", "to 4000 deg", "W593"),
    ("toggle", "along 0 deg", "along 90 rad", "W245"),
    # a length
    ("oscillating_cylinder", "400 mm .. 900 mm", "-400 mm .. 900 mm", "W246"),
    ("oscillating_cylinder", "r = 400 mm", "r = 400 mm +- 500 mm", "W246"),
    ("oscillating_cylinder", "r = 400 mm", "r = 400 m", "W247"),
    ("crank_rocker", "b   = 120 mm", "b   = -120 mm", "E245"),
    # what drives
    ("oscillating_cylinder", "CB = s", "CB = 500 mm", "W249"),
    ("oscillating_cylinder", "drive s", "drive r", "W250"),
    ("crank_rocker", "drive phi from 0 deg to 360 deg", "drive d", "W250"),
    # friction
    ("karpenko_fig9_with_friction", "f     = 0.1 ", "f     = 2 ", "W251"),
    ("karpenko_fig9_with_friction", "d     = 20 mm", "d     = 200 mm", "W257"),
    # bodies and joints
    ("crank_rocker", "at (d, 0 mm)", "at (0 mm, 0 mm)", "W252"),
    ("toggle", "link OB", "link OBA\nlink OB", "W253"),
    ("oscillating_cylinder", "telescope CB", "telescope CB\ntelescope OB", "W254"),
    ("oscillating_cylinder", "telescope CB", "telescope CB\ntelescope OC", "W254"),
    ("oscillating_cylinder", "telescope CB", "telescope CB\nlink OC", "W262"),
    ("crank_rocker", "cw", "cw\nassembly ABO2 ccw", "E319"),
    # what is asked for, and of what size
    ("toggle", "find k = P/F", "find k = P/F\nfind j = P/F", "W248"),
    ("wheelbarrow", "m     = 60 kg", "m     = 0 kg", "W255"),
    ("crank_rocker", "find k", "let F = 0 N\nfind k", "W255"),
    ("crank_rocker", "find k", "let z = 1/(a - 40 mm)\nfind k", "W256"),
    ("toggle", "find k", "let F = 2 kN\nlet P = 1 kN\nfind k", "W288"),
    ("wheelbarrow", "m     = 60 kg", "m     = 60 kg*9.81", "W278"),
    ("wheelbarrow", "m     = 60 kg", "m     = 60 kg\nparam g = 9.81 mm/s^2", "W286"),
    ("wheelbarrow", "m     = 60 kg", "m     = 60 kg\nparam g = -9.81 m/s^2", "E235"),
    ("oscillating_cylinder", "actuator P between C and B", "actuator P between O and B", "W277"),
    # friction
    ("karpenko_fig9_with_friction", "find k =", "find k_f =", "W263"),
    ("karpenko_fig7_with_friction", "axle d wheel D", "axle D wheel d", "E421"),
    # conditions, ranges, expectations
    ("toggle", "find k", "require alpha = 10 deg\nfind k", "W281"),
    ("toggle", "find k", "require 1 mm < 2 mm\nfind k", "W282"),
    ("toggle", "expect k = 0.353 at", "expect k = 0.353 +- 0.5 at", "W280"),
    ("toggle", "0.353 at alpha = 10 deg", "2.384 at alpha = 50 deg", "W285"),
    ("toggle", "at alpha = 10 deg", "at alpha = 12 deg, alpha = 10 deg", "E330"),
    ("crank_rocker", "a   = 40 mm", "a   = 40 mm in 20 mm .. 400 mm", "W284"),
    ("toggle", "find k", "let s = pi*50 mm^2/4\nfind k", "W279"),
    ("crank_rocker", "to 360 deg", "to 360 deg speed 0 rpm", "W255"),
)
"""A library mechanism, what a person meant and wrote, and the code of what is said of it."""


@pytest.mark.parametrize(("name", "meant", "written", "code"), KINDS, ids=str)
@pytest.mark.parametrize("notation", in_thirds(["mech", "yaml"]))
def test_kinds_of_mistakes_are_named(name, meant, written, code, notation):
    text = TOGGLE if name == "toggle" else library()[name].read_text("utf-8")
    assert meant in text
    source = Source("a.mech", text.replace(meant, written, 1))
    if notation == "yaml":
        source = Source("a.yaml", to_yaml(read(source, Report(source))))
    assert code in codes(source)


ANY_SIZE = """param L = 1.2 m
param e = 4 mm
param m = 0 kg in 0 kg .. 10 kg
pivot O
link OAB
OA = L @ 20 deg
OB = (-100 mm, e)
weight W mass m at A
force F at B along -y
find F
"""


def test_a_right_description_is_not_doubted():
    assert not codes(Source("a.mech", ANY_SIZE))


def codes(source: Source) -> list[str]:
    compilation = Compilation(source)
    try:
        found = complete(compilation).report.diagnostics
    except MechcError as error:
        found = list(error.diagnostics)
    return [d.code for d in found]


LOOSE = (
    ("slider K along 90 deg\n", "hold link BK, which hangs on pin B alone"),
    ("pivot O\n", "hold link OB, which hangs on pin B alone"),
    ("link BK\n", "join link OB to slider K: nothing does"),
)


@pytest.mark.parametrize(("line", "hint"), LOOSE)
def test_what_hangs_loose_is_named(line, hint):
    with pytest.raises(MechcError) as error:
        complete(Compilation(Source("a.mech", TOGGLE.replace(line, ""))))
    assert error.value.diagnostics[-1].hint == f"write `find` for exactly 2 loads, or {hint}"


@pytest.mark.parametrize(
    ("meant", "written"),
    [
        ("find k = P/F", "find j = P/F"),
        ("find k = P/F", "find k = P/G"),
        ("param alpha", "param alfa"),
        ("P at B", "P at Q"),
    ],
)
def test_one_mistake_is_stated_once(meant, written):
    (found,) = codes(Source("a.mech", TOGGLE.replace(meant, written, 1)))
    assert found.startswith("E2")


HARMLESS = re.compile(r'(?s)param \w+ = [\d.]+ \w+ as "cylinder bore"|drive .*|param d .*')
"""A bore stands in a formula of the user's own only; a second drive is another matter."""


def test_some_mistakes_are_seen():
    assert not [found for found in silent(drawn(1, 60)) if not HARMLESS.fullmatch(found[1])]


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(2, 4))
def test_many_mistakes_are_seen(seed):
    assert not [found for found in silent(drawn(seed, 250)) if not HARMLESS.fullmatch(found[1])]
