"""Several mechanisms in one table: the scheme of each beside the formulas of its own report."""

import re

import pytest

from good_mechanisms import loaded
from mechc.cli import main
from tex import compile_tex, needs_cyrillic

DRAWN = """mechanism lever "Crane"
translate "Crane" uk "Кран"
param a = 900 mm
param b = 100 mm
pivot O
slider B along y
link OA
link AB
OA = a @ 85 deg
AB = b @ 100 deg
force P at A along x
force F at B along -y
find k = P/F
find R_O
param d = 20 mm
let q = sqrt((4*F/(pi*d^2) + 32*F*a/(pi*d^3))^2 + 3*(16*F*b/(pi*d^3))^2)
"""
SCHEMES = ("karpenko_fig1_parallel_levers", "karpenko_fig2_scissor_tongs")


def table(capsys, *line):
    assert main(["report", *SCHEMES, *line]) == 0
    return capsys.readouterr().out


@pytest.mark.parametrize(
    ("language", "head"),
    [("en", "No. & Scheme &"), ("uk", "№ & Схема & Передавання сили"), ("ru", "№ & Схема &")],
)
def test_each_row_has_the_scheme_and_the_formulas_of_the_report(language, head, capsys):
    text = table(capsys, "--lang", language)
    assert head in text
    rows = re.split(r"^\\midrule$", text, flags=re.M)[1:]
    for number, (name, row) in enumerate(zip(SCHEMES, rows, strict=True), start=1):
        report = loaded(name).emit("latex", language=language)
        assert f"{number} &" in row
        assert row.count(r"\begin{tikzpicture}") == 1
        formulas = re.findall(r"\\boxed\{.*\}", row)
        assert len(formulas) == 3
        assert all(formula in report for formula in formulas)


def test_without_schemes_and_as_a_fragment(capsys, tmp_path):
    text = table(capsys, "--no-schemes", "--fragment")
    assert text.startswith(r"\providecommand{\mechccyr}")
    assert r"\documentclass" not in text
    assert "tikzpicture" not in text
    assert main(["report", *SCHEMES, "-o", str(tmp_path / "t.tex")]) == 0
    assert (tmp_path / "t.tex").read_text("utf-8") == table(capsys)


def test_what_friction_rests_on_is_defined_and_more_formulas_stay_in_their_column(capsys):
    assert main(["report", "fedoriv_fig1_with_friction", "--fragment"]) == 0
    text = capsys.readouterr().out
    assert r"\boxed{\beta=\arcsin" in text
    beside, below = text.split("& &\n")
    assert "k_{\\mathrm{hold}}=" in beside
    assert "\\eta_k=" in below
    assert r"\multicolumn" not in text


def test_a_sheet_has_no_row(capsys, tmp_path):
    (tmp_path / "s.mech").write_text("sheet s\nparam a = 1 m\nlet b = a\n")
    assert main(["report", SCHEMES[0], str(tmp_path / "s.mech")]) == 1
    out, err = capsys.readouterr()
    assert (out, "E704" in err) == ("", True)


def test_a_scheme_is_bounded_and_wide_results_stand_below_it(capsys, tmp_path):
    (tmp_path / "lever.mech").write_text(DRAWN)
    assert main(["report", str(tmp_path / "lever.mech"), "--fragment", "--lang", "uk"]) == 0
    text = capsys.readouterr().out
    assert r"\resizebox{!}{1.2\linewidth}{%" in text, "it is taller than wide"
    beside, below = text.split(r"\multicolumn{3}{@{}p{\linewidth}@{}}{%")
    assert "k=\\frac{P}{F}" in beside
    assert beside.index("\n{") < beside.index("R_{O,x}&="), "its & would end the cell"
    assert "q=" in below


@pytest.mark.slow
def test_pdflatex_sets_the_table(capsys, tmp_path):
    needs_cyrillic()
    (tmp_path / "lever.mech").write_text(DRAWN)
    names = [str(tmp_path / "lever.mech"), *SCHEMES]
    assert main(["report", *names, "--lang", "uk"]) == 0
    log = compile_tex("pdflatex", capsys.readouterr().out, tmp_path)
    assert "Overfull" not in log


def test_what_only_a_formula_of_the_users_rests_on_is_not_defined(capsys):
    """There beta is asin(f*d/L), and nothing mentions the radius of the friction circle."""
    assert main(["report", "fedoriv_fig2a_with_friction", "--no-schemes", "--fragment"]) == 0
    page = capsys.readouterr().out
    assert r"\beta=\arcsin" in page
    assert r"\rho" not in page
