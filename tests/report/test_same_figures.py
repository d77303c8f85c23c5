"""A page, the terminal and a check give the same figures, in every language."""

import re
from functools import cache

import pytest

from good_mechanisms import ALL, compiled
from mechc.cli.check_lines import report as checked
from mechc.emit.latex.to_latex import TARGET
from mechc.emit.target import Options
from mechc.report.languages.registry import locale
from mechc.report.text.derivation import render

LANGUAGES = ("en", "uk", "ru")
QUICK = (
    *("crank_rocker", "claw_with_friction", "d45_11_screw_lever_with_friction", "excavator_arm"),
    *("cabinet_on_casters", "table_4_4_gear_with_efficiency", "whitworth", "plate_clutch"),
)
DECIMAL = re.compile(r"\d+\.\d+")
ON_PAGES_ALONE = re.compile(
    r"[^\n]*\\cdot 10\^\{-\d+\}\}?\$\)\.|\\setlength.*|\[\d.*?pt\]|\d\.\d+\\linewidth"
)
"""How well the equilibrium agrees, and lengths on the page."""


@cache
def on_page(name: str, language: str) -> frozenset[str]:
    """Return the decimals of a LaTeX report."""
    (file,) = TARGET.emit(compiled(name), Options(name, language=language, fragment=True))
    text = ON_PAGES_ALONE.sub("", file.text.replace("{,}", "."))
    parts = re.findall(r"\\frac\{(\d+)\}\{(\d+)\}", text)
    return decimals(text, language) | {f"{int(over) / int(under):.12g}" for over, under in parts}


@cache
def in_terminal(name: str, language: str) -> frozenset[str]:
    """Return the decimals of a derivation, of its last part those of the values alone."""
    compilation = compiled(name)
    text = render(compilation.derivation, compilation.mechanism, language=language, width=10**6)
    before, _, values = text.partition(f"\n{locale(language).numbers}\n")
    lines = [line.rpartition(" = ")[2] for line in values.splitlines()]
    return decimals("\n".join((before, *lines)), language)


def decimals(text: str, language: str) -> frozenset[str]:
    plain = text if language == "en" else re.sub(r"(?<=\d),(?=\d)", ".", text)
    return frozenset(DECIMAL.findall(plain))


def differ(name: str) -> set[str]:
    """Return the decimals that some output has and another lacks."""
    page, terminal = on_page(name, "en"), in_terminal(name, "en")
    others = [(on_page(name, each), in_terminal(name, each)) for each in LANGUAGES[1:]]
    between = set[str]().union(*(page ^ p | terminal ^ t for p, t in others))
    return between | (terminal - page)


@pytest.mark.parametrize("name", QUICK)
def test_all_outputs_have_the_same_figures(name: str) -> None:
    assert len(in_terminal(name, "en")) > 2
    assert differ(name) == set()


@pytest.mark.slow
@pytest.mark.parametrize("name", sorted(ALL.keys() - set(QUICK))[::2])
def test_all_outputs_of_every_second_mechanism_have_the_same_figures(name: str) -> None:
    assert differ(name) == set()


@pytest.mark.parametrize("name", QUICK)
def test_a_check_rounds_to_the_figures_of_the_derivation(name: str) -> None:
    for language in LANGUAGES:
        said = "\n".join(checked(compiled(name), verbose=False, language=language))
        found = re.findall(r"^    = (-?[\d.,]+)", said, re.MULTILINE)
        rounded = {f"{abs(float(figure.replace(',', '.'))):.6g}" for figure in found}
        shown = {f"{float(figure):.6g}" for figure in in_terminal(name, language)}
        assert {figure for figure in rounded if "." in figure} <= shown
