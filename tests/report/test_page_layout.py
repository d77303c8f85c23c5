"""What stands where on a page: pictures that leave none half empty, tables in one piece."""

import re
from functools import cache

import pytest

import mechc
from good_mechanisms import OF_LIBRARY, compiled, loaded
from mechc.emit.latex.tables import tabular
from mechc.formula.tree import Call, Symbol, product
from mechc.plot.query import rows
from mechc.report.latex.display import DisplayLine, display
from mechc.report.latex.notation import notation
from mechc.report.latex.printer import box, row


@cache
def page(name: str) -> str:
    return loaded(name).emit("latex", pictures=True)


def test_free_bodies_and_plots_may_go_to_the_next_page():
    text = page("crank_rocker")
    scheme, bodies, plot = (text.index(f"\\small {c}") for c in ("Kine", "Free", "$k$ against"))
    assert text.rindex(r"\begin{center}", 0, scheme) > text.find(r"\begin{figure}", 0, scheme)
    for caption in (bodies, plot):
        assert text.rindex(r"\begin{figure}[!htb]", 0, caption) > scheme
    assert text.count(r"\begin{figure}") == text.count(r"\end{figure}") == 2


def test_the_check_is_before_the_table():
    text = page("bell_crank")
    assert text.index("Check: the equilibrium") < text.rindex(r"\begin{tabular}")


@pytest.mark.parametrize("name", ["band_brake", "jansen_leg", "toggle_press", "double_butterfly"])
def test_short_tables_are_not_parted(name):
    text = loaded(name).emit("latex")
    for table in re.findall(r"\\endhead\n(.*?)\\bottomrule", text, re.DOTALL):
        found = table.splitlines()
        assert len(found) >= 16 or all(line.endswith(r"\\*") for line in found)
        assert all(line.count(r"\\") == 1 for line in found)


def test_what_directions_are_is_said_before_they_are_used():
    text = loaded("block_and_tackle").emit("latex")
    assert text.index("Directions are angles") < text.index("in the direction")


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", "driving coordinate"),
        ("uk", "узагальнена координата"),
        ("ru", "обобщённая координата"),
    ],
)
def test_the_parameter_of_the_drive_is_called_so(language, said):
    text = loaded("crank_rocker").emit("latex", language=language)
    assert re.search(rf"\$\\varphi\$ & .*{said}", text)
    assert said not in loaded("four_bar").emit("latex", language=language)


def test_lines_of_a_sheet_begin_with_a_capital_letter():
    sheet = loaded("grip_force")
    assert r"\noindent Force of one jaw:" in sheet.emit("latex")
    assert "{Сила" in sheet.emit("latex", language="uk")


@pytest.mark.parametrize(
    ("name", "x", "count"),
    [
        ("jansen_leg", "phi", 13),  # 0° … 360°: every 30°
        ("karpenko_fig3_inclined_levers", "alpha", 14),  # 1° … 40°: every 3°
        ("crank_slider", "phi", 18),  # 5° … 175°: every 10°
        ("fedoriv_fig1_with_friction", "alpha", 12),  # 1° … 45°: every 4°
        ("band_brake", "mu", 13),  # 0.1 … 0.4: every 0.025
        ("scissor_table", "s", 11),  # 0.65 m … 0.94 m: no step is round
        ("three_claw_gripper", "phi", 11),  # 1 … 2 rad: every 0.1
    ],
)
def test_tables_have_round_steps(name, x, count):
    assert rows(x, compiled(name).mechanism) == count


def test_formulas_of_sources_are_formulas():
    text = loaded("four_bar").emit("latex")
    assert r"\ensuremath{\omega}\ensuremath{{}_4}/\ensuremath{\omega}" in text
    texts = (path.read_text(encoding="utf-8") for path in OF_LIBRARY)
    sources = [found[1] for text in texts if (found := re.search(r"(?m)^source:? (.*)", text))]
    assert len(sources) > len(OF_LIBRARY) / 2
    for source in sources:
        assert not re.search(r"omega|alpha|beta|theta|sqrt|\w\*\w|\^2", source)


def test_what_follows_the_check_is_a_paragraph_of_its_own():
    after = page("crank_rocker").split("largest relative difference")[1]
    assert after.splitlines()[1] == ""


def test_a_condition_of_a_used_sheet_is_called_after_it(tmp_path):
    path = tmp_path / "s.mech"
    path.write_text(
        "sheet s\nparam F = 2 kN\nuse cylinder as cyl (P = F)\nlet d = 2*cyl_d\n", "utf-8"
    )
    text = mechc.load(path).emit("latex")
    assert "\ncylinder: $" in text
    assert "(cylinder): $0" not in text


def test_free_bodies_of_many_links_are_legible():
    """Ten links and pins go on over two pages, in letters of nine points and more."""
    text = page("jansen_leg")
    assert r"\small Free bodies (continued)" in text
    scales = [float(s) for s in re.findall(r"\\scalebox\{([\d.]+)\}", text)]
    assert min(scales) > 0.8


def test_the_line_above_a_table_is_on_its_page():
    """A center environment lets a page end between the two."""
    text = page("jansen_leg")
    above = text[: text.rindex(r"\begin{tabular}")].splitlines()
    assert above[-2:] == [
        r"\medskip\noindent Results along the stroke:",
        r"\par\nobreak\medskip{\centering",
    ]


def test_lines_of_one_equation_are_on_one_page() -> None:
    text = mechc.load("examples/gripper/linkage.mech").emit("latex")
    continued = re.findall(r"\\\\(\*?)(?:\[2pt])?\n&\\quad", text)
    assert continued
    assert set(continued) == {"*"}


def test_a_long_chain_of_ratios_has_a_line_of_its_own() -> None:
    """What the product is equal to is on the next line whole, no factor of it behind a sign."""
    style = notation("en")
    long = product([(Call("sin", (Symbol(f"alpha_{i}"),)), 1) for i in range(8)])
    chain = row(tuple(box(Symbol(f"V_{i}"), style) for i in range(20)))
    line = DisplayLine(box(Symbol("i"), style), long, chain=chain)
    shown = display((line,), style, "where")
    assert r"\times" not in shown
    assert len(re.findall(r"\\\*\[2pt]\n&\\quad\{\}=\\sin", shown)) == 1
    short = line._replace(right=Symbol("k"), chain=box(Symbol("r"), style))
    assert display((short,), style, "where") == "\\[\ni=r=k\n\\]"


def test_what_is_said_of_a_formula_of_a_sheet_is_on_its_page() -> None:
    """Which size of a list was taken stood at the head of the next page."""
    text = mechc.load("examples/pin.mech").emit("latex")
    said = r"\noindent (the next size of"
    assert said in text
    before = text[: text.index(said)].rstrip()
    assert before.endswith("\\]\n}%")
    assert before.rindex(r"{\postdisplaypenalty=10000") > before.rindex(r"\noindent")


@pytest.mark.parametrize(("rows", "columns", "blocks"), [(20, 3, 2), (20, 5, 1), (8, 3, 1)])
def test_a_long_narrow_table_is_set_in_halves(rows: int, columns: int, blocks: int) -> None:
    lines = list(tabular(["x"] * columns, [[str(row)] * columns for row in range(rows)]))
    assert sum(line.startswith(r"\begin{tabular}") for line in lines) == blocks
    shown = [line.split(" ")[0] for line in lines if line[0].isdigit()]
    assert shown == [str(row) for row in range(rows)]
