"""The LaTeX report: its text, and that every engine compiles it."""

import re
from collections.abc import Callable
from pathlib import Path
from string import Formatter
from typing import get_args

import pytest
from jinja2 import meta

import mechc
from good_mechanisms import loaded
from mechc.emit.latex.blocks import ReportContext
from mechc.emit.latex.to_latex import TARGET
from mechc.emit.make_templates import EMIT, environment
from mechc.emit.target import Options
from mechc.files import find
from mechc.formula.tree import Call, Sum, Symbol
from mechc.report.kinds import PositionKind, StepRule
from mechc.report.languages import en, ru, uk
from mechc.report.languages.locale import Locale
from mechc.report.latex.display import vanishing
from mechc.report.latex.letters import CYRILLIC, LATIN
from mechc.report.latex.notation import notation
from report_samples import packet_clamp, six_bar
from small_mechanisms import vice
from tex import compile_tex, needs_cyrillic

NASTY = r"50% of A&B_{x} #1 \input{/etc/passwd} ~^$ Кран λ «ёлка» – naïve “q” 中 `a' --- <<"
NASTY += (
    "Ħal Tarxien ŧoggle ấ Ợ ử q̃ Μηχανισμός ἀ Ə ẞ Đ ŋ ſ ĸ ﬁ H₂O 10⁻⁴ ⅓ а́ Ѣ Қ م 😀 ⌀20 ″ ∠ € ‰ ‚›"
)
LANGUAGES = ("en", "uk", "ru")
TABLES = {"en": en.LOCALE, "uk": uk.LOCALE, "ru": ru.LOCALE}


def report(language: str = "en", fragment: bool = False, title: str = "") -> str:
    options = Options("clamp", fragment, language)  # type: ignore[arg-type]
    (emitted,) = TARGET.emit(packet_clamp(title), options)
    assert emitted.name == "clamp.tex"
    return emitted.text


@pytest.mark.parametrize("language", LANGUAGES)
def test_clamp_golden(language: str, golden: Callable[[str, str], None]) -> None:
    golden(f"latex/clamp_{language}.tex", report(language))


def test_fragment_golden(golden: Callable[[str, str], None]) -> None:
    golden("latex/clamp_fragment.tex", report(fragment=True))


def test_k_is_what_the_paper_prints() -> None:
    k = r"\boxed{k=\frac{P}{F}=\frac{a}{2b}\cdot\frac{\sin(\alpha+\beta)}{\cos\alpha\cos\beta}}"
    assert k in report()


def test_fragment_has_no_preamble_and_the_same_content() -> None:
    fragment = report(fragment=True)
    assert "\\documentclass" not in fragment
    body = fragment.replace("\\subsection*", "\\section*")
    assert body in report().replace("\\lastsection\n", "")


def test_output_depends_on_the_input_only() -> None:
    assert report() == report()
    assert "\\today" not in report()


def test_template_uses_every_field_of_the_report() -> None:
    tree = environment("latex").parse(template("latex/body.jinja"))
    used = meta.find_undeclared_variables(tree)
    assert used == set(ReportContext._fields)


def template(name: str) -> str:
    """Return a template with those that it includes put in."""
    source = (EMIT / name).read_text("utf-8")
    return re.sub(r'<% include "(.*?)" %>', lambda match: template(match[1]), source)


def test_library_reports_say_no_more_than_there_is() -> None:
    text = find("crank_slider").read_text("utf-8").split("translate")[0]
    plain = mechc.loads(re.sub(r"  # .*", "", text)).emit("latex")
    labelled = loaded("wheelbarrow").emit("latex")
    assert "Quantity" not in plain
    assert "Range" not in loaded("shoe_brake").emit("latex")
    assert "Quantity" in labelled
    assert "W=mg$, $g=9.80665" in labelled


def test_a_length_between_points_keeps_off_the_speed() -> None:
    assert r"V_A=O_{1}A\cdot \omega_{O_{1}A}" in loaded("stephenson_six_bar").emit("latex")


OFFSET_SLIDER = """
param r = 30 mm
param phi = 50 deg
pivot O at (0 m, 0 m)
slider B along x through (0 m, 20 mm)
link OA
link AB
OA = r @ phi
AB = 0.1 m
torque M on OA
force F at B along -x
find k = M/F
"""


def test_given_places_have_their_unit_and_are_no_joints() -> None:
    text = mechc.loads(OFFSET_SLIDER).emit("latex")
    assert r"Pinned to the ground: $O$." in text
    assert r"with the direction $0^\circ$, through $B_{0}$." in text
    assert r"$B_{0}$ & $(0,y_{B_{0}})$" in text
    assert r"$y_{B_{0}}$ & coordinate of the guide of $B$ & $20\,\text{mm}$" in text
    assert r"$AB$ & $0.1\,\text{m}$" in text


LEVER_ON_A_ROD = """
param alpha = 15 deg
pivot C
slider S along x
link CAD
link SA
CA = 60 mm @ 90 deg - alpha
CD = 90 mm @ 90 deg - alpha
SA = 50 mm @ 10 deg
force P at S along x
force F at D along -x
find P
find N_SA
friction pin C 0.1 diameter 10 mm
"""


def test_a_direction_is_in_degrees_and_a_radius_has_its_unit() -> None:
    text = mechc.loads(LEVER_ON_A_ROD).emit("latex")
    assert r"10^\circ" in text
    assert r"the radius of its friction circle is $\frac{f_Cd_C}{2}$" in text
    assert r"$d_C$ & diameter of the pin & $10\,\text{mm}$" in text


def test_signed_speeds_are_not_called_magnitudes() -> None:
    clamp = loaded("equalising_clamp").emit("latex")
    assert en.LOCALE.signed in clamp
    assert en.LOCALE.magnitudes not in clamp


def test_a_long_power_equation_is_broken() -> None:
    terms = [Call("sin", (Symbol(f"alpha_{i}"),)) for i in range(40)]
    shown = vanishing(Sum(tuple(terms)), notation("en"), "where")
    assert shown.startswith("\\begin{multline*}")
    assert shown.endswith("=0\n\\end{multline*}")
    assert shown.count("\\\\\n") > 2


@pytest.mark.parametrize("name", ["double_butterfly", "jansen_leg", "triad_closed"])
def test_a_name_made_up_for_a_sum_is_defined_once(name: str) -> None:
    text = loaded(name).emit("latex").split(r"\section*{Numerical values}")[0]
    made = re.findall(r"([YZ]_\d|[YZ]_\{\d+\})&?=(?!0\$)", text)
    assert made
    assert len(made) == len(set(made))
    assert set(made) == set(re.findall(r"(?<![A-Za-z{])[YZ]_(?:\d|\{\d+\})", text))


def test_a_name_made_up_for_a_sum_is_no_point() -> None:
    leg = loaded("jansen_leg").emit("latex")
    assert "Z_1" not in leg  # whose rocker turns about Z
    assert "Y_1" in leg


# --------------------------------------------------------------------------- words


def entries(words: Locale) -> dict[str, str]:
    flat: dict[str, str] = {}
    for field, value in words._asdict().items():
        if field in ("units", "functions", "decimal", "phi", "cyrillic"):
            continue
        if isinstance(value, str):
            flat[field] = value
        else:
            flat |= {f"{field}.{key}": text for key, text in value.items()}
    return flat


def placeholders(text: str) -> set[str]:
    """Return the places of a sentence, forms of words that agree with what is meant aside."""
    fields = {field for _, field, _, _ in Formatter().parse(text) if field}
    return {field for field in fields if field != "forms" and not field.startswith("of_")}


@pytest.mark.parametrize("language", ["uk", "ru"])
def test_forms_of_words_serve_a_force_a_couple_and_where_there_may_be_many_all_of_them(
    language: str,
) -> None:
    for text in entries(TABLES[language]).values():
        for _, field, forms, _ in Formatter().parse(text):
            if field and field.startswith("of_"):
                several = field != "of_drive"
                assert len((forms or "").split("|")) == (3 if several else 2), text


@pytest.mark.parametrize("language", ["uk", "ru"])
def test_every_language_says_the_same(language: str) -> None:
    english, other = entries(en.LOCALE), entries(TABLES[language])
    assert other.keys() == english.keys()
    for key, text in other.items():
        assert bool(text) == bool(english[key]), key
        if not key.startswith("rules."):
            assert placeholders(text) == placeholders(english[key]), key


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_rule_has_words(language: str) -> None:
    assert set(TABLES[language].rules) == {rule.value for rule in StepRule}


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_kind_of_loop_has_words(language: str) -> None:
    assert set(TABLES[language].loops) == set(get_args(PositionKind))


def test_ukrainian_and_russian_name_the_same_units() -> None:
    assert uk.LOCALE.units.keys() == ru.LOCALE.units.keys()


# ------------------------------------------------------------------------- engines


@pytest.mark.parametrize("language", LANGUAGES)
def test_pdflatex_sets_the_report(language: str, tmp_path: Path) -> None:
    if language != "en":
        needs_cyrillic()
    log = compile_tex("pdflatex", report(language), tmp_path)
    assert "Overfull" not in log


@pytest.mark.parametrize("language", ["en", "uk"])
def test_pdflatex_sets_any_title(language: str, tmp_path: Path) -> None:
    needs_cyrillic()
    log = compile_tex("pdflatex", report(language, title=NASTY), tmp_path)
    assert "Missing character" not in log


def test_long_formulas_stay_on_the_page(tmp_path: Path) -> None:
    (emitted,) = TARGET.emit(six_bar(), Options("six_bar"))
    log = compile_tex("pdflatex", emitted.text, tmp_path)
    assert "Overfull" not in log


def test_long_conditions_stay_within_the_margin(tmp_path: Path) -> None:
    """Products in a line of mathematics have few places at which it may be broken."""
    needs_cyrillic()
    text = mechc.loads(vice("find F", "find n = F/P")).emit("latex", language="uk")
    assert "Overfull" not in compile_tex("pdflatex", text, tmp_path)


@pytest.mark.parametrize("name", ["lever_first_class", "wheelbarrow"])
def test_few_lines_are_not_left_for_a_last_page(name: str, tmp_path: Path) -> None:
    assert "(1 page," in compile_tex("pdflatex", loaded(name).emit("latex"), tmp_path)


def about_the_checks(before: str, folder: Path) -> list[float]:
    """Return how full the page is above and below the heading of the checks of a note."""
    text = loaded("groove_size").emit("latex")
    heading, how_far = r"\section*{Checks}", r"\typeout{page: \the\pagetotal}"
    text = text.replace(r"\par\penalty-100 ", rf"\par{before}\penalty-100 {how_far}")
    log = compile_tex("pdflatex", text.replace(heading, f"{heading}{how_far}"), folder)
    return [float(found) for found in re.findall(r"page: ([\d.]+)pt", log)]


def test_the_checks_of_a_note_follow_it_at_once(tmp_path: Path) -> None:
    r"""Room kept below the heading of the table is no gap above it."""
    above, below = about_the_checks("", tmp_path)
    assert 10 < below - above < 50


def test_the_checks_begin_a_page_where_little_is_left_of_one(tmp_path: Path) -> None:
    """A break that came with the table would print its heading on either side."""
    fill = r"\vspace*{\dimexpr\pagegoal-\pagetotal-6\baselineskip}"
    above, below = about_the_checks(fill, tmp_path)
    assert below < 60 < above


def test_fragment_can_be_included(tmp_path: Path) -> None:
    (tmp_path / "clamp.tex").write_text(report(fragment=True), encoding="utf-8")
    host = (
        "\\documentclass{article}\\usepackage{amsmath,array,booktabs,longtable}\n"
        "\\begin{document}\\section{Clamp}\\input{clamp}\\end{document}\n"
    )
    compile_tex("pdflatex", host, tmp_path)


@pytest.mark.slow
@pytest.mark.parametrize("engine", ["xelatex", "lualatex"])
@pytest.mark.parametrize("language", LANGUAGES)
def test_unicode_engines_set_any_title(engine: str, language: str, tmp_path: Path) -> None:
    compile_tex(engine, report(language, title=NASTY), tmp_path)


@pytest.mark.parametrize("language", ["en", "uk", "ru"])
@pytest.mark.parametrize("mechanism", ["triad_closed", "claw_with_friction", "band_brake"])
def test_all_signs_are_in_the_encodings_or_spelled(mechanism, language):
    """The angle of three points is set by mathematics, as all that pdfTeX has no letter for."""
    text = loaded(mechanism).emit("latex", language=language, pictures=True)
    bare = re.sub(r"\\mechcchar\{[0-9A-F]+\}\{[^}]*\}", "", text)
    assert set(bare) <= LATIN | CYRILLIC | set("\n’—»«…")
    assert r"$\angle CBD$" in text or mechanism != "triad_closed"
