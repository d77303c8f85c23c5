"""Every word of the grammar goes the whole way: both notations, all targets, words and pictures."""

import json
import re
from functools import cache

import pytest

import mechc
from good_mechanisms import ALL
from mechc.api import SolvedMechanism
from mechc.diagnostics import Report
from mechc.emit.registry import BUILT_IN
from mechc.files import data
from mechc.report.languages.registry import LANGUAGES
from mechc.source import Source
from mechc.syntax.notation import read
from mechc.syntax.to_dsl import to_dsl
from mechc.syntax.to_yaml import to_yaml
from paths import LIBRARY

LAMP = """mechc 1
mechanism lamp "Lamp on a spring"
param a = 90 mm in 80 mm .. 100 mm
pivot O at (0 mm, 0 mm)
pivot S at (-30 mm, 120 mm)
link OAL
A at (a, 100 mm)
L at (310 mm, 330 mm)
drive OA from 20 deg to 60 deg speed 10 rpm
spring 1.2 N/mm between S and A free 40 mm
weight W mass 0.8 kg at L
torque M on OAL
friction pin O 0.1 diameter 8 mm coulomb
motion tightening
find M
report scheme, M, plot M over phi_OA
translate "Lamp on a spring" en "Lamp with a spring"
"""
PLUNGER = """mechanism plunger
param mu = 0.1
param l = 100 mm
pivot O
slider K along x through O
link OB
link BK
OB = l @ 120 deg
BK = 1.5*l
assembly K back
torque M on OB
force F at K along -x
friction pins mu diameter 8 mm journal
friction slider K mu guide 80 mm overhang 20 mm {shape}
friction collar O mu {collar} thrust F
find M
"""
JOINED = """mechanism pulled
slider K along x
link AK
AK = 200 mm @ 10 deg
use toggle_clamp as T at (10 mm, 0 mm) turned 20 deg joining T.H = A without P
force P at K along x
find k = P/T_F
"""
BOLT = """
sheet bolt
param d_min = 7.6 mm in 5 mm .. 12 mm
list threads "ISO 262" = 6 mm, 8 mm, 10 mm, 12 mm
table pitches "ISO 261" = 6 mm: 1 mm, 8 mm: 1.25 mm, 10 mm: 1.5 mm, 12 mm: 1.75 mm
let d = next d_min in threads
let p = pitches at exactly d
"""
OWN = {
    "bolt": BOLT,
    "lamp": LAMP,
    "overhang_edges": PLUNGER.format(shape="edges", collar="outer 40 mm inner 20 mm wear"),
    "overhang_linear": PLUNGER.format(shape="linear", collar="outer 40 mm inner 20 mm pressure"),
    "pulled": JOINED,
}
LINES = {name: path for name, path in ALL.items() if path.suffix == ".mech"}
SHEETS = {path.stem: path for path in sorted((LIBRARY / "sheets").glob("*.mech"))}
TEXTS = OWN | {name: path.read_text("utf-8") for name, path in (LINES | SHEETS).items()}


def words_of_the_grammar() -> set[str]:
    grammar = (data("grammar") / "mechc.lark").read_text("utf-8")
    return set(re.findall(r'"([a-z_]+)"', re.sub(r"//.*", "", grammar)))


def words_of(text: str) -> set[str]:
    return set(re.findall(r"[a-z_]+", re.sub(r'"[^"\n]*"|#.*', "", text)))


@cache
def cover() -> tuple[str, ...]:
    """A few descriptions that have all words among them: each time the one with most new words."""
    open_words, chosen = words_of_the_grammar(), []
    while open_words:
        best = max(TEXTS, key=lambda name: len(open_words & words_of(TEXTS[name])))
        if not open_words & words_of(TEXTS[best]):
            break
        chosen.append(best)
        open_words -= words_of(TEXTS[best])
    return tuple(chosen)


def test_every_word_has_a_description():
    assert words_of_the_grammar() <= {word for name in cover() for word in words_of(TEXTS[name])}


def formulas(mechanism: SolvedMechanism) -> dict[str, list[str]]:
    """The terms of each result; the loads of YAML, and so the terms, have another order."""
    results = json.loads(mechanism.emit("json"))["results"]
    texts = {result["name"]: result["formula"]["text"] for result in results}
    return {n: sorted(text.replace(" - ", " + -").split(" + ")) for n, text in texts.items()}


@pytest.mark.slow
@pytest.mark.parametrize("name", cover())
def test_it_goes_the_whole_way(name):
    source = Source(f"{name}.mech", TEXTS[name])
    tree = read(source, Report(source))
    lines, yaml = mechc.loads(to_dsl(tree), "a.mech"), mechc.loads(to_yaml(tree), "a.yaml")
    assert to_dsl(read(Source("a.mech", to_dsl(tree)), Report(source))) == to_dsl(tree)
    assert formulas(lines) == formulas(yaml)
    for target in BUILT_IN:
        assert lines.emit(target)
        assert yaml.emit(target)
    for language in LANGUAGES:
        assert lines.emit("latex", language=language)
    assert lines.derivation
    if re.search("^link ", TEXTS[name], re.MULTILINE):
        assert "<svg" in lines.draw()._repr_svg_()
