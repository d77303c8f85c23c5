"""Pictures of a report: each at its place, in the language, and only where they are asked for."""

import re

import pytest

import mechc
from good_mechanisms import begun, loaded
from mechc.cli import main
from mechc.report.languages import registry
from readable_drawings import lettering
from small_mechanisms import jib

CAPTIONS = {
    "en": ("Kinematic scheme", "Free bodies", "$k$ against $\\alpha$"),
    "uk": ("Кінематична схема", "Ланки, звільнені від в’язей", "Залежність $k$ від $\\alpha$"),
    "ru": (
        "Кинематическая схема",
        "Звенья, освобождённые от связей",
        "Зависимость $k$ от $\\alpha$",
    ),
}


@pytest.fixture(scope="module")
def clamp():
    return loaded("karpenko_fig9_packet_clamp")


@pytest.mark.parametrize("language", CAPTIONS)
def test_each_picture_is_at_its_place(language, clamp):
    text = clamp.emit("latex", language=language, pictures=True)
    places = [text.index(f"{{\\small {caption}\\par}}") for caption in CAPTIONS[language]]
    heads = [i for i in range(len(text)) if text.startswith("\\section*{", i)]
    given, *_, results, numbers = heads
    assert given < places[0] < heads[1] < places[1] < results < places[2] < numbers
    assert text.count(r"\begin{tikzpicture}") == 3
    assert r"\usepackage{pgfplots}" in text


@pytest.mark.parametrize("language", CAPTIONS)
def test_free_bodies_are_headed_in_the_language(language):
    words = registry.locale(language).pictures
    drawing = begun("karpenko_fig9_with_friction").drawn_bodies(language)
    heads = [text for text in lettering(drawing) if text.startswith("k, ")]
    per = words["per"].format(load="F")
    assert heads == [f"k, {words['without']}, {per}", f"k, {words['with']}, {per}"]


def test_the_table_has_the_values_of_the_plot_in_the_language(clamp):
    text = clamp.emit("latex", language="uk", pictures=True)
    assert r"$\alpha$, $^\circ$ & $k$ \\" in text
    assert "$2$ & $0{,}03154$" in text
    assert "ymin=0.0" in text
    assert "$0{,}05$" in text


JIB = jib("let W = 1 kN", "find k = P/W, R_B on OBA")


def test_lengths_and_directions_of_forces_read_in_pictures_and_tables_as_in_formulas():
    text = mechc.loads(JIB).emit("latex", pictures=True)
    assert r"$\varphi_{{R_B^{OBA}}}$, $^\circ$" in text
    assert "direction}" not in text
    assert not re.search(r"\blen\b", text)


def test_none_unless_asked_for(clamp, capsys):
    assert "tikz" not in clamp.emit("latex")
    fragment = clamp.emit("latex", pictures=True, fragment=True)
    assert fragment.count(r"\begin{tikzpicture}") == 3
    assert "usepackage" not in fragment
    assert main(["compile", "karpenko_fig9_packet_clamp", "--emit", "latex", "--pictures"]) == 0
    assert "Kinematic scheme" in capsys.readouterr().out


def test_with_friction_both_are_plotted_and_over_the_stroke_of_a_drive():
    text = loaded("karpenko_fig9_with_friction").emit("latex", pictures=True)
    assert "against $\\alpha$" in text
    assert "& $k$ & $" in text
    assert "$k$ against $\\varphi$" in loaded("crank_rocker").emit("latex", pictures=True)


def test_what_has_no_range_has_no_plot_and_a_sheet_no_pictures(tmp_path):
    lever = loaded("lever_first_class").emit("latex", pictures=True)
    assert lever.count(r"\begin{tikzpicture}") == 2
    sheet = loaded("pin_joint").emit("latex", pictures=True)
    assert "tikzpicture" not in sheet
