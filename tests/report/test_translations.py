"""Titles, labels and remarks in the language of the report."""

import re
from pathlib import Path

import pytest

import mechc
from good_mechanisms import compiled, loaded
from mechc.compilation import Compilation
from mechc.drawing.drawing import TextRun
from mechc.drawing.language_letters import spelled
from mechc.drawing.lettering import name
from mechc.formula.letters import letters
from mechc.report.languages.registry import LANGUAGES, locale
from mechc.report.text import note
from mechc.report.text.derivation import render
from mechc.report.text.speller import speller
from mechc.source import Source
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

NAMES = (
    SHEET.replace("chosen", "d_taken")
    + """
let far = 2*F_C
let F_C = 2 kN
translate "pins" uk "пальці"
translate "F_C" uk "F_з"
"""
)


def report(text: str, language: str) -> str:
    """Return a report without what chooses fonts."""
    return _plain(mechc.loads(text, "m.mech").emit("latex", language=language))


def _plain(page: str) -> str:
    return re.sub(r"\\mechccyr\{([^{}]*)\}", r"\1", page)


def test_names_and_the_words_in_them_are_translated() -> None:
    page, compilation = report(NAMES, "uk"), Compilation(Source("m.mech", NAMES))
    spell = speller(compilation.results, compilation.mechanism, unicode=True, language="uk")
    text = note.render(compilation.mechanism, compilation.results, spell)
    for part in (r"d_{\text{прийнято}}", r"\text{пальці}", r"F_{\text{з}}"):
        assert part in page
    assert all(n in text for n in ("d_прийнято = ", "пальці = 6 мм", "F_з = 2 кН"))
    assert "ряду «пальці»" in text
    assert all(n in report(NAMES, "ru") for n in (r"d_{\mathrm{taken}}", "F_C"))


def test_names_in_pictures_are_those_of_the_page() -> None:
    known = letters(locale("uk"), {"far": "дал", "F_C": "F_ц", "довге плече": "arm"})
    found = spelled((*name("P_far"), TextRun(", "), *name("F_C")), known)
    assert [run.text for run in found] == ["P", "дал", ", ", "F", "ц"]


def test_a_used_sheet_brings_the_translations_of_its_names(tmp_path: Path) -> None:
    (tmp_path / "pin.mech").write_text(NAMES, encoding="utf-8")
    (tmp_path / "whole.mech").write_text('sheet whole\nuse "pin.mech" as L\n', encoding="utf-8")
    page = _plain(mechc.load(tmp_path / "whole.mech").emit("latex", language="uk"))
    assert all(n in page for n in (r"d_{\text{прийнято},L}", r"F_{\text{з},L}"))


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
    assert all(text in shown for text in ("Палець на зріз", "допустиме напруження", "Прийнято"))


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


TOGGLE = """
mechanism toggle
param alpha = 10 deg in 1 deg .. 45 deg
param L_guide = 80 mm
pivot E
slider C along 0 deg
link EB
link BC
EB = L_guide @ alpha
BC = L_guide @ -alpha
force Q at B along -90 deg
force W at C along 180 deg
friction slider C 0.1
friction pins 0.1 diameter 10 mm
find k = Q/W
"""


def test_subscripts_of_mechc_are_in_the_language_and_those_of_the_user_stay():
    said = {lang: mechc.loads(TOGGLE).emit("latex", language=lang) for lang in ("en", "uk", "ru")}
    assert r"k_{\mathrm{hold}}" in said["en"]
    assert r"k_{\text{утр}}" in said["uk"]
    assert r"k_{\text{уд}}" in said["ru"]
    for language in ("uk", "ru"):
        assert r"r_{C,\text{напр}}" in said[language]
        assert r"L_{\mathrm{guide}}" in said[language]
        assert "hold" not in said[language]


@pytest.mark.parametrize("language", ["uk", "ru"])
def test_so_are_those_of_a_derivation_in_the_terminal(language: str) -> None:
    compilation = Compilation(Source("toggle.mech", TOGGLE))
    shown = render(compilation.derivation, compilation.mechanism, language=language)
    assert "r_C_напр" in shown
    assert "L_guide" in shown
    assert not re.search("_hold|C_guide", shown)


@pytest.mark.parametrize(
    ("name", "subject"),
    [("band_brake", "forces"), ("four_bar", "force ratio"), ("jaw_crusher", "force ratio")],
)
def test_a_report_is_headed_by_what_it_is_about(name: str, subject: str) -> None:
    for language in LANGUAGES:
        subjects = locale(language).subjects
        head = loaded(name).emit("latex", language=language)[:2500]
        assert [key for key, said in subjects.items() if said in head] == [subject]


@pytest.mark.parametrize("language", ["uk", "ru"])
def test_numbers_of_a_derivation_have_decimal_commas(language):
    compilation = compiled("wheelbarrow")
    shown = render(compilation.derivation, compilation.mechanism, language=language)
    assert "9,80665" in shown
    assert "= 213,853 " in shown
    assert not re.search(r"\d\.\d", shown)


def test_a_prefix_is_translated(tmp_path: Path) -> None:
    (tmp_path / "pin.mech").write_text(NAMES, encoding="utf-8")
    whole = 'sheet whole\nuse "pin.mech" as rod_pin\ntranslate "rod_pin" uk "вісь"\n'
    (tmp_path / "whole.mech").write_text(whole, encoding="utf-8")
    page = _plain(mechc.load(tmp_path / "whole.mech").emit("latex", language="uk"))
    assert r"F_{\text{вісь}}" in page
    assert r"\text{rod pin}" not in page
