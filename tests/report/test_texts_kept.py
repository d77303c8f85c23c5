"""What the user says of quantities and links stands wherever they are shown."""

import pytest

import mechc
from good_mechanisms import loaded
from mechc.compilation import Compilation
from mechc.report.text.derivation import render
from mechc.source import Source

PRESS = """
mechanism press "title of the press"
source "source of the press"
param a = 50 mm as "label of a" about "more about a"   # no text beside a label
param b = 100 mm                                       # remark on b
param d = 10 mm +- 0.1 mm                              # remark on d
param phi = 40 deg in 10 deg .. 80 deg                 # remark on phi
pivot O at (0 mm, 0 mm)
slider K along 0 deg through O
link OA "name of OA"
link AK "name of AK"
OA = a @ phi
AK = b
drive phi from 10 deg to 80 deg
torque M on OA
force F at K along 180 deg
let F = 500 N                                          # remark on F
let p = 4*F/(pi*d^2) in MPa as "label of p"
let q = 2*p in MPa                                     # remark on q
find k = M/F
"""

HEAD = {"title of the press", "source of the press"}
GIVEN = {"label of a", "more about a", "remark on b", "remark on phi"}
LINKS = {"name of OA", "name of AK"}
FORMULAS = {"label of p", "remark on q"}
INTRODUCTIONS = {"Label of p", "Remark on q"}
"""The same where a formula follows them: they begin a line, with a capital letter."""

KEPT = {
    "latex": HEAD | GIVEN | LINKS | INTRODUCTIONS | {"remark on d", "remark on F"},
    "json": HEAD | GIVEN | LINKS | FORMULAS | {"remark on d", "remark on F"},
    "python": HEAD | GIVEN | FORMULAS | {"remark on d"},
    "c": HEAD | GIVEN | FORMULAS | {"remark on d"},
}


@pytest.mark.parametrize("target", KEPT)
def test_texts_stand_in_every_output(target: str) -> None:
    shown = mechc.loads(PRESS).emit(target).replace("$", "")
    assert {text for text in KEPT[target] if text not in shown} == set()
    assert "no text beside" not in shown


def test_texts_stand_in_the_derivation() -> None:
    compilation = Compilation(Source("press.mech", PRESS))
    shown = render(compilation.derivation, compilation.mechanism)
    assert {text for text in KEPT["json"] - LINKS if text not in shown} == set()


@pytest.mark.parametrize("language", ["en", "uk", "ru"])
def test_a_picture_names_links_in_its_language(language: str) -> None:
    translated = PRESS + 'translate "name of OA" uk "кривошип" ru "кривошип"\n'
    shown = mechc.loads(translated).draw(language=language)._repr_svg_()
    assert ("OA (name of OA)" if language == "en" else "OA (кривошип)") in shown
    assert "AK (name of AK)" in shown


def test_a_quantity_that_a_text_names_is_set_as_in_formulas() -> None:
    assert "force $F$ &" in loaded("tongs_fig4_9_forces").emit("latex")
