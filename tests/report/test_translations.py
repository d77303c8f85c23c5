"""Titles, labels and remarks in the language of the report."""

import re
from pathlib import Path

import pytest

import mechc
from mechc.report.languages.registry import LANGUAGES
from mechc.syntax import vocabulary

LEVER = """
mechanism lever "Lever of a press"
source "own"
param a = 100 mm as "long arm" about "from the pivot"
param b = 20 mm
pivot O
link AOB
OA = a @ 180 deg
OB = b @ 0 deg
force P at A along -y
force F at B along -y
find k = P/F
translate "Lever of a press" uk "Важіль преса" ru "Рычаг пресса"
translate "own" uk "власне"
translate "long arm" uk "довге плече"
"""

SHEET = """
sheet pin "Pin in shear"
param F = 3 kN as "force"
param tau = 60 MPa  # allowable stress
let d = sqrt(4*F/(pi*tau)) in mm as "diameter"
let chosen = next d in pins  # taken
list pins "a standard" = 6 mm, 8 mm, 10 mm
require F > 0 N  # a force
translate "Pin in shear" uk "Палець на зріз"
translate "force" uk "сила"
translate "allowable stress" uk "допустиме напруження"
translate "diameter" uk "діаметр"
translate "taken" uk "прийнято"
translate "a standard" uk "стандарт"
translate "a force" uk "є сила"
"""


def report(text: str, language: str) -> str:
    """Return a report without what chooses fonts."""
    shown = mechc.loads(text, "m.mech").emit("latex", language=language)
    return re.sub(r"\\mechccyr\{([^{}]*)\}", r"\1", shown)


def test_texts_are_in_the_language_where_they_are_translated() -> None:
    english, ukrainian, russian = (report(LEVER, language) for language in LANGUAGES)
    assert all(text in english for text in ("Lever of a press", "own", "long arm; from the pivot"))
    assert all(
        text in ukrainian for text in ("Важіль преса", "власне", "довге плече; from the pivot")
    )
    assert not any(text in ukrainian for text in ("Lever", "own", "long arm"))
    assert all(text in russian for text in ("Рычаг пресса", "own", "long arm"))


def test_a_sheet_is_translated_whole() -> None:
    shown = report(SHEET, "uk")
    assert not re.search("Pin in|force|allowable|diameter|taken|standard", shown)
    assert all(text in shown for text in ("Палець на зріз", "допустиме напруження", "прийнято"))


def test_what_is_used_brings_its_translations(tmp_path: Path) -> None:
    (tmp_path / "pin.mech").write_text(SHEET, encoding="utf-8")
    own = 'sheet mine\nparam P = 2 kN\nuse "pin.mech" as p (F = P)\n'
    (tmp_path / "mine.mech").write_text(own, encoding="utf-8")
    mechanism = mechc.load(tmp_path / "mine.mech")
    assert not mechanism.warnings
    shown = mechanism.emit("latex", language="uk")
    shown = re.sub(r"\\mechccyr\{([^{}]*)\}", r"\1", shown)
    assert "допустиме напруження (pin)" in shown
    assert not re.search("allowable|diameter|taken", shown)


@pytest.mark.parametrize("target", ["python", "c", "json"])
def test_code_keeps_what_was_written(target: str) -> None:
    without = "\n".join(line for line in LEVER.splitlines() if "translate" not in line)
    assert mechc.loads(LEVER).emit(target) == mechc.loads(without).emit(target)


def test_texts_go_into_all_languages_of_reports() -> None:
    assert set(vocabulary.LANGUAGES) == set(LANGUAGES)
