"""What notebooks show: Markdown and HTML of mechanism, result, derivation and stroke."""

import re
import shutil
import subprocess
from collections.abc import Callable
from html.parser import HTMLParser
from pathlib import Path

import pytest

import mechc
from good_mechanisms import loaded
from paths import ROOT
from small_mechanisms import drawn_six_bar

SHOWN = ("crank_rocker", "fedoriv_fig1_with_friction", "karpenko_fig9_packet_clamp", "cylinder")


def balanced(markdown: str) -> bool:
    """Tell whether displays and environments are closed, and nothing in them is for a page."""
    opened, closed = (re.findall(rf"\\{w}\{{(.*?)\}}", markdown) for w in ("begin", "end"))
    inline = re.sub(r"\$\$", "", markdown).count("$")
    signs = markdown.count("$$") % 2 == 0 and inline % 2 == 0
    paper = r"\\(?:item|noindent|medskip|section|\[(?!\d)|mechc)"
    return signs and sorted(opened) == sorted(closed) and not re.search(paper, markdown)


@pytest.mark.parametrize("name", SHOWN)
def test_mechanisms_results_and_derivations_show_themselves(name: str) -> None:
    mechanism = loaded(name)
    whole = mechanism._repr_markdown_()
    derivation = mechanism.derivation._repr_markdown_()
    assert balanced(whole)
    assert balanced(derivation)
    for result in mechanism.results.values():
        shown = result._repr_markdown_()
        assert balanced(shown)
        assert "=" in shown


@pytest.mark.parametrize("name", SHOWN)
def test_what_a_printed_notebook_shows_is_latex(name: str, typeset: Callable[[str], str]) -> None:
    mechanism = loaded(name)
    shown = [mechanism, mechanism.derivation, *mechanism.results.values()]
    log = typeset("\n\n".join(one._repr_latex_() for one in shown))
    assert "Overfull" not in log


@pytest.fixture
def typeset(tmp_path: Path) -> Callable[[str], str]:
    """Return a function that sets LaTeX in a document as notebooks do; it gives the log."""
    if shutil.which("pdflatex") is None:
        pytest.skip("no pdflatex")

    def call(body: str) -> str:
        text = HEAD + body + "\n\\end{document}\n"
        (tmp_path / "shown.tex").write_text(text, encoding="utf-8")
        command = ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "shown.tex"]
        done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stdout[-2000:]
        return done.stdout

    return call


HEAD = r"""\documentclass[11pt]{article}
\usepackage[margin=22mm]{geometry}
\usepackage{amsmath,amssymb,array,booktabs,longtable}
\begin{document}
"""


def test_texts_of_the_user_are_text_in_a_notebook() -> None:
    said = "тиск σ² — «так», 50 % of a·b ‘q’ Ẑ - x"
    sheet = f'mechanism p "{said}"\nparam a = 5 mm\nlet b = a^2  # {said}\n'
    rod = "pivot O\nlink AOB\nOA = a @ 180 deg\nOB = 2*a @ 0 deg\nfind k = P/F\n"
    loads = "force P at A along -y\nforce F at B along -y\n"
    mechanism = mechc.loads(sheet + rod + loads)
    for shown in (mechanism._repr_markdown_(), mechanism.derivation._repr_markdown_()):
        line = said.replace("%", chr(92) + "%").replace("тиск", "Тиск")
        line = line.replace("a·b", "$a$·$b$")
        assert f"\n{line}:\n" in shown
        assert balanced(shown)
    assert "\n- $k$" in mechanism.derivation._repr_markdown_()


def test_a_result_shows_all_that_it_rests_on() -> None:
    shown = loaded("crank_rocker").results["k"]._repr_markdown_()
    assert r"\boxed{k=\frac{M}{F}=" in shown
    for name in (r"\psi&=", r"\theta&=", r"\mu_B&="):
        assert shown.count(name) == 1


def test_a_derivation_is_in_order() -> None:
    shown = loaded("crank_rocker").derivation._repr_markdown_()
    places = [shown.index(f"**{title}**") for title in ("Position", "Velocities", "Results")]
    assert places == sorted(places)


class Cells(HTMLParser):
    """Counts the cells of each row."""

    def __init__(self) -> None:
        super().__init__()
        self.rows: list[int] = []

    def handle_starttag(self, tag: str, attrs: object) -> None:
        """Count a row or a cell."""
        if tag == "tr":
            self.rows.append(0)
        elif tag in ("td", "th"):
            self.rows[-1] += 1


def test_a_stroke_is_a_table() -> None:
    stroke = loaded("crank_rocker").stroke(5)
    cells = Cells()
    cells.feed(stroke._repr_html_())
    assert cells.rows == [4] * 6
    table = stroke.table()
    assert list(table)[:3] == ["phi", "k", "i"]
    assert table["k"] == [row.values[0] for row in stroke.rows]


@pytest.mark.parametrize("friction", ["", "friction pins 0.1 diameter 12 mm\n"])
def test_a_mechanism_with_forces_at_joints_shows_itself(friction: str) -> None:
    """The direction of a force is that of its components, which stand above it, or put in."""
    text = (ROOT / "examples" / "strength" / "clamp.mech").read_text("utf-8").split("let l")[0]
    clamp = mechc.loads(text + friction)
    shown = clamp._repr_latex_()
    assert r"\varphi_{R_O}=\operatorname{atan2}(R_{O,y},R_{O,x})" in shown
    alone = clamp.results["R_O_direction"]._repr_latex_()
    assert r"\varphi_{R_O}=\operatorname{atan2}\left(-F" in alone
    assert "R_{O,y}" not in alone
    assert len(clamp._repr_markdown_()) == len(shown.replace(r"\[", "$$").replace(r"\]", "$$"))


def test_a_step_alone_has_no_number() -> None:
    crank, rocker = loaded("bell_crank"), loaded("crank_rocker")
    assert r"\begin{enumerate}" not in crank.emit("latex")
    assert r"\begin{enumerate}" in rocker.emit("latex")
    assert "1\\. " not in crank.derivation._repr_markdown_()
    assert "1\\. " in rocker.derivation._repr_markdown_()


CHOICE = """mechanism lever
param v = 1 m/s
param b = 200 mm
let a = 50 mm when v < 2 m/s else 80 mm
pivot O
link AOB
OA = a @ 180 deg
OB = b @ 0
force P at A along 90 deg
force F at B along 90 deg
find k = P/F
"""


def test_a_choice_has_its_units() -> None:
    shown = mechc.loads(CHOICE, "lever.mech").results["k"]._repr_latex_()
    assert r"50\,\text{mm}, & v<2\,\text{m}/\text{s} \\ 80\,\text{mm}" in shown


def test_an_angle_of_a_drawn_link_is_in_degrees_once() -> None:
    r"""It was turned into degrees twice: ``-3527.546446^\circ^\circ``."""
    shown = mechc.loads(drawn_six_bar()).results["k"]._repr_markdown_()
    assert r"\delta_{BQC}&=-61.5673^\circ" in shown
    assert r"^\circ^\circ" not in shown


def test_a_result_has_the_directions_that_the_report_has() -> None:
    shown = mechc.loads(drawn_six_bar()).results["k"]._repr_markdown_()
    assert r"\cos(\beta_{CK}+\varphi_{QC})" in shown
    assert r"\varphi_{QC}&=\varphi_{AB}+\mu_B+\delta_{BQC}" in shown
