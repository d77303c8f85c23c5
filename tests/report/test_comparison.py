"""Several mechanisms in one table: the scheme of each beside the formulas of its own report."""

import re

import pytest

import mechc
from mechc.cli import main

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
        report = mechc.load(name).emit("latex", language=language)
        assert f"{number} &" in row
        assert row.count(r"\begin{tikzpicture}") == 1
        formulas = re.findall(r"\\boxed\{.*\}", row)
        assert len(formulas) == 3
        assert all(formula in report for formula in formulas)


def test_without_schemes_and_as_a_fragment(capsys, tmp_path):
    text = table(capsys, "--no-schemes", "--fragment")
    assert text.startswith(r"\begin{longtable}")
    assert "tikzpicture" not in text
    assert main(["report", *SCHEMES, "-o", str(tmp_path / "t.tex")]) == 0
    assert (tmp_path / "t.tex").read_text("utf-8") == table(capsys)


def test_a_sheet_has_no_row(capsys, tmp_path):
    (tmp_path / "s.mech").write_text("sheet s\nparam a = 1 m\nlet b = a\n")
    assert main(["report", SCHEMES[0], str(tmp_path / "s.mech")]) == 1
    out, err = capsys.readouterr()
    assert (out, "E704" in err) == ("", True)
