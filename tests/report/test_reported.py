"""``report …``: what a description wants in its report, and nothing else."""

import pytest

import mechc
from good_mechanisms import loaded
from mechc.cli import main

SLOPE = r"$\mathrm{d}k/\mathrm{d}\varphi$"

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


@pytest.mark.parametrize(("language", "mm"), [("en", "mm"), ("uk", "мм")])
def test_the_table_along_the_stroke_has_every_column(language, mm):
    text = report("report stroke", language)
    unit = rf"$\text{{{mm}}}$"
    assert rf"$\varphi$, $^\circ$ & $k$, {unit} & $i$ & {SLOPE}, {unit}" in text
    assert r"$V_{B,F}/\omega_{OA}=-k$" in text  # along F, not as B moves
    assert r"$\mu_B$" in text


@pytest.mark.parametrize(
    ("language", "speed", "spin", "angle"),
    [
        (
            "en",
            "$V_{B,F}$ is the component of the velocity of $B$ along $F$.",
            r"$\omega_{OA}$ is the angular velocity of $OA$, positive counter-clockwise.",
            r"$\mu_B$ is the transmission angle at $B$, between $AB$ and $QB$.",
        ),
        (
            "uk",
            "$V_{B,F}$ — проєкція швидкості точки $B$ на напрям сили $F$.",
            r"$\omega_{OA}$ — кутова швидкість ланки $OA$, додатна проти годинникової стрілки.",
            r"$\mu_B$ — кут передачі в шарнірі $B$ між ланками $AB$ та $QB$.",
        ),
        (
            "ru",
            "$V_{B,F}$ — проекция скорости точки $B$ на направление силы $F$.",
            r"$\omega_{OA}$ — угловая скорость звена $OA$, положительная против часовой стрелки.",
            r"$\mu_B$ — угол передачи в шарнире $B$ между звеньями $AB$ и $QB$.",
        ),
    ],
)
def test_what_stands_in_the_table_alone_is_explained_below_it(language, speed, spin, angle):
    below = report("report stroke", language).rpartition(r"\end{tabular}")[2]
    assert speed in below
    assert spin in below
    assert angle in below


def test_numbers_of_a_column_have_the_same_decimals():
    text = report("report stroke").rpartition(r"\begin{tabular}")[2]
    rows = [line.split(" & ") for line in text.splitlines() if line.startswith("$")][1:]
    for column in zip(*rows, strict=True):
        assert len({len(cell.strip("$ \\").partition(".")[2]) for cell in column}) == 1


def test_what_is_constant_along_the_stroke_is_no_column():
    text = report("let j = 2*a in mm\nreport stroke")
    said = text.partition("Throughout, ")[2].partition(".")[0]
    assert r"$j=80\,\text{mm}$" in said
    assert "& $j$" not in text


def test_a_plot_over_something_else_keeps_its_table():
    wide = ROCKER.replace("param c = 80 mm", "param c = 80 mm in 70 mm .. 90 mm")
    text = mechc.loads(f"{wide}report plot i over c, stroke\n", "rocker.mech").emit("latex")
    assert SLOPE in text
    assert r"$c$, $\text{mm}$ & $i$" in text


def test_units_and_decimals_of_pictures_are_those_of_the_language():
    plans = report("report plans", "ru")
    assert r"{,}" in plans
    assert "V}_{\\mathit{A}}/\\text{\\mechccyr{м}}" in plans
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


def test_a_ratio_that_is_another_one_is_shown_once():
    text = loaded("crank_slider").emit("latex")
    speed = text.partition(r"\textbf{Velocity ratio:}")[2]
    assert "$i$ = $k$: what is said of $k$ holds for it, too." in speed
    assert "vanishes" not in speed
    assert "vanishes" in text


@pytest.mark.parametrize(
    ("name", "said"),
    [
        (
            "d45_11_screw_lever",
            r"where $m$ vanishes, $n$ becomes infinite, and vice versa; "
            "where $m$ rises, $n$ falls, and vice versa.",
        ),
        ("d45_10_two_screws", None),
    ],
)
def test_what_is_said_of_a_ratio_is_not_said_of_its_inverse(name, said):
    text = loaded(name).emit("latex").rpartition(r"\textbf{Force transmission coefficient:}")[2]
    stated = [line.strip() for line in text.splitlines() if r"\item " in line]
    inverse = r"\item $n=\frac{1}{m}$"
    assert stated == [f"{inverse}: {said}" if said else f"{inverse}."]
    assert "partial" not in text


def test_what_is_nothing_but_rounding_is_zero_in_a_table():
    table = loaded("crank_slider").emit("latex", pictures=True).rpartition(r"\toprule")[2]
    assert r"$165$ & $0.000$ \\" in table
    assert "10^{" not in table


@pytest.mark.parametrize(
    ("language", "said"), [("en", "Throughout,"), ("uk", "На всьому ході"), ("ru", "На всём ходе")]
)
def test_a_ratio_of_speeds_that_is_a_result_has_no_column(language, said):
    """V_B/ω is −k by the balance of two loads: the table had both."""
    text = mechc.load("crank_rocker").emit("latex", language=language, pictures=True)
    ratio = r"$V_{B,F}/\omega_{O_{1}A}"
    assert rf"{said} {ratio}=-k$" in text
    assert f"{ratio}$, " not in text
