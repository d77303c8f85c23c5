"""``report …``: what a description wants in its report, and nothing else."""

import pytest

import mechc
from mechc.cli import main

ROCKER = """
mechanism rocker
param a = 40 mm
param b = 120 mm
param c = 80 mm
param d = 100 mm
param phi = 60 deg in 0 deg .. 360 deg
param psi: angle
param theta: angle
pivot O at (0 mm, 0 mm)
pivot Q at (d, 0 mm)
link OA
link AB
link QB
OA = a @ phi
AB = b @ psi
QB = c @ theta
assembly ABQ cw
drive phi from 0 deg to 360 deg
torque M on OA
force F at B along perp BQ
find k = M/F
find i = omega_QB/omega_OA
"""


def report(line, language="en", **options):
    return mechc.loads(f"{ROCKER}{line}\n", "rocker.mech").emit(
        "latex", language=language, **options
    )


def test_pictures_are_those_that_are_named():
    text = report("report plans, plot i over phi")
    assert text.count(r"\begin{tikzpicture}") == 2
    assert "Plans of velocities and of forces" in text
    assert "$i$ against $\\varphi$" in text
    assert "Kinematic scheme" not in text
    assert r"\usepackage{pgfplots}" in text


def test_results_are_those_that_are_named():
    assert "Velocity ratio" not in report("report k")
    whole = report("report scheme")
    assert r"\frac{M}{F}" in whole
    assert "omega_{QB}" in whole.split(r"\section*{Results}")[1]
    only = report("report k").split(r"\section*{Results}")[1]
    assert "omega_{QB}" not in only
    assert "tikzpicture" not in only


SLOPE = r"$\mathrm{d}k/\mathrm{d}\varphi$"


@pytest.mark.parametrize(("language", "mm"), [("en", "mm"), ("uk", "мм")])
def test_the_table_along_the_stroke_has_every_column(language, mm):
    text = report("report stroke", language)
    unit = rf"$\text{{{mm}}}$"
    assert rf"$\varphi$, $^\circ$ & $k$, {unit} & $i$ & {SLOPE}, {unit}" in text
    assert r"$V_{B,F}/\omega_{OA}$" in text  # along F, not as B moves
    assert r"$\mu_B$" in text


def test_a_plot_over_something_else_keeps_its_table():
    wide = ROCKER.replace("param c = 80 mm", "param c = 80 mm in 70 mm .. 90 mm")
    text = mechc.loads(f"{wide}report plot i over c, stroke\n", "rocker.mech").emit("latex")
    assert SLOPE in text
    assert r"$c$, $\text{mm}$ & $i$" in text


def test_units_and_decimals_of_pictures_are_those_of_the_language():
    plans = report("report plans", "ru")
    assert r"{,}" in plans
    assert "V}_{\\mathrm{A}}/\\mbox{\\mechccyr{м}}" in plans
    assert "mathrm{/m}" not in plans


def test_a_part_that_there_is_not_is_reported_at_its_place(capsys, tmp_path):
    path = tmp_path / "rocker.mech"
    path.write_text(f"{ROCKER}report schemes, k\n")
    assert main(["check", str(path)]) == 1
    said = capsys.readouterr().err
    assert "rocker.mech:24:8: error[E336]: a report holds no 'schemes'" in said
    assert "did you mean 'scheme'?" in said


def test_the_new_words_are_names_elsewhere():
    text = ROCKER.replace("param a = 40 mm", "param plot = 40 mm").replace("OA = a", "OA = plot")
    over = text.replace("param b = 120 mm", "param over = 120 mm").replace("AB = b", "AB = over")
    found = mechc.loads(over.replace("find i", "find report"), "rocker.mech")
    assert set(found.results) == {"k", "report"}


def test_a_load_that_is_asked_for_is_a_result():
    text = ROCKER.replace("find k = M/F", "find M")
    page = mechc.loads(f"{text}report M\n", "rocker.mech").emit("latex")
    assert "\\omega_{QB}" not in page
    plotted = mechc.loads(f"{text}let F = 2 N\nreport M, plot M over phi\n").emit("latex")
    assert "\\begin{tikzpicture}" in plotted
