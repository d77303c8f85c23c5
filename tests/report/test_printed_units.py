"""Any relation on a page of the library balances in units, and its numbers come to its values."""

import math
import re
from pathlib import Path

import pytest

import mechc
from paths import LIBRARY
from printed_units import PrintedUnits, displaced, extents

FILES = sorted(p for p in LIBRARY.rglob("*") if p.suffix in {".mech", ".yaml"})
LANGUAGES = ("en", "uk", "ru")

QUICK = {"gripper_closed", "jansen_leg", "lever_clamp_with_friction", "wedge_drive_with_friction"}
QUICK |= {"claw_angles", "cylinder", "prism_jaws", "wheelbarrow", "triad_press", "tongs_fig4_9"}


def chosen(path: Path) -> object:
    return pytest.param(path, marks=() if path.stem in QUICK else pytest.mark.slow, id=path.stem)


def printed(path: Path, language: str = "en") -> str:
    return mechc.load(path).emit("latex", language=language)


def wrong(tex: str) -> list[str]:
    page = PrintedUnits(tex)
    return [*page.contradictions(), *page.unread]


@pytest.mark.parametrize(
    "path", [chosen(p) for i, p in enumerate(FILES) if i % 2 or p.stem in QUICK]
)
def test_units_and_numbers_of_a_page_agree(path):
    tex = printed(path)
    assert wrong(tex) == []
    assert list(displaced(tex)) == []


TRANSLATED = [(path, LANGUAGES[1 + i // 2 % 2]) for i, path in enumerate(FILES) if i % 2 == 0]
"""The files whose English page is not read, by turns in the one language and the other."""


@pytest.mark.slow
@pytest.mark.parametrize(("path", "language"), TRANSLATED, ids=lambda p: getattr(p, "stem", p))
def test_units_and_numbers_of_a_translated_page_agree(path, language):
    assert wrong(printed(path, language)) == []


def test_a_page_is_read_in_earnest():
    page = PrintedUnits(printed(LIBRARY / "gripper_closed.mech"))
    assert list(page.contradictions()) == []
    assert page.read_relations > 18
    assert page.valued > 4
    assert len(list(extents(page.tex))) == 2


@pytest.mark.parametrize(
    ("printed_there", "instead", "left"),
    [
        (r"(15\,\text{mm})^{2}", r"15\,\text{mm}^{2}", "AO"),
        (r"33.541\,\text{mm}", r"33.541\,\text{m}", "AO"),
        (r"33.541\,\text{mm}", r"33.551\,\text{mm}", "AO"),
        (r"\boxed{k=\frac{P}{F}=\frac{2b}{a}", r"\boxed{k=\frac{P}{F}=\frac{2b}{a^{2}}", "k"),
        (r"\boxed{k=\frac{P}{F}=\frac{2b}{a}", r"\boxed{k=\frac{P}{F}=\frac{3b}{a}", "k"),
        (r"V_B\sin\mu_B=V_A\cos", r"aV_B\sin\mu_B=V_A\cos", "aV_B\\sin\\mu_B"),
        (r"PV_A+2FV_{J,F}", r"P+2FV_{J,F}", "P+2FV_{J,F}"),
    ],
)
def test_a_wrong_page_is_seen(printed_there, instead, left):
    tex = printed(LIBRARY / "gripper_closed.mech")
    assert printed_there in tex
    found = wrong(tex.replace(printed_there, instead))
    assert left in {text.split(" = ")[0] for text in found}


def test_a_name_is_as_exact_as_the_numbers_in_its_formula():
    """tan 88.361439 deg - 34.95 is 0.0076: six figures of its terms leave an eighth of it open."""
    page = "\\[\nZ=\\tan 88.361439^\\circ-34.95\n\\]\n\\[\nk=-Z\n\\]\n"
    exact = math.tan(math.radians(88.3614394)) - 34.95
    assert list(PrintedUnits(page, {"k": -exact}).contradictions()) == []
    assert list(PrintedUnits(page, {"k": -1.2 * exact}).contradictions())


def test_an_extremum_at_another_place_is_seen():
    tex = printed(LIBRARY / "gripper_closed.mech")
    assert "at $s=44$ mm" in tex
    assert len(list(displaced(tex.replace("at $s=44$ mm", "at $s=43$ mm")))) == 1


def test_what_was_found_is_put_in_as_it_was_printed():
    tex = printed(LIBRARY / "sheets" / "prism_jaws.mech")
    assert r"39.1548\,\text{N}+49.6515\,\text{N}+5.58517\,\text{N}=94.3914\,\text{N}" in tex


@pytest.mark.parametrize(("language", "letter"), [("en", "m"), ("uk", "м"), ("ru", "м")])
def test_a_reciprocal_is_written_one_way_in_sentences_numbers_and_axes(language, letter):
    text = (LIBRARY / "triad_closed.mech").read_text("utf-8").replace("k = M/F", "k = F/M")
    lines = [line for line in text.splitlines() if not line.startswith("expect")]
    solved = mechc.loads("\n".join(lines), "m.mech")
    page = solved.emit("latex", language=language, pictures=True).replace(r"\mechccyr", "")
    assert page.count(rf"~$\text{{{letter}}}^{{-1}}$") == 2  # at the least and at the greatest
    axis = next(line for line in page.splitlines() if "ylabel" in line)
    assert "^{{-}1}" in axis
    assert "1/" not in axis
    assert not re.search(r"1/(\\text\{)?[mм]", page)
