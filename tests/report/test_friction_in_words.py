"""What code and its docstrings say of friction: the printed case, not the signs it takes."""

import re
from functools import cache

import pytest

import mechc
from good_mechanisms import begun, compiled, loaded
from mechc.cli.check_lines import report
from mechc.compilation import compile_source
from mechc.files import find, read
from mechc.formula.evaluate import evaluate
from mechc.formula.to_text import text
from mechc.formula.tree import Sum
from mechc.report.sentences.speller import LoadWords
from mechc.report.text.derivation import render
from mechc.source import Source
from paths import LIBRARY
from small_mechanisms import LOADED_COUPLER, follower, gear_train


def docstring(code: str, name: str) -> str:
    return code.partition(f"def {name}(")[2].partition('"""')[2].partition('"""')[0]


@pytest.mark.parametrize("result", ["k_f", "k_hold"])
def test_a_docstring_shows_the_printed_case(result):
    shown = docstring(loaded("karpenko_fig1_with_friction").emit("python"), result)
    assert "sigma" not in shown
    assert "sign(" not in shown
    assert f"{result} = 2*" in shown
    assert "    while\n" in shown
    assert f"it is that of {result}_coupled." in shown
    assert f"{result}_status tells." in shown


PINS = "param f_p = 0.1\nparam d_p = 12 mm\nfriction pins f_p diameter d_p\nfind R_A on AB"
ROCKER = (
    (LIBRARY / "crank_rocker.mech").read_text("utf-8").replace("at B along", "at B on AB along")
)
ITERATED = f"{ROCKER}\n{PINS}\nlet twice = 2*k_f\n"


@cache
def iterated() -> "mechc.Mechanism":
    return mechc.loads(ITERATED, "crank.mech")


def test_a_docstring_shows_the_structure_of_what_is_iterated():
    shown = docstring(iterated().emit("python"), "k_f")
    assert "n = |r + D*n|" in shown
    assert "rho*n_A*Omega_A" in shown
    assert " d_A" not in shown


def test_so_does_that_of_a_formula_which_rests_on_it():
    shown = docstring(iterated().emit("python"), "twice")
    assert "twice = 2*k_f" in shown
    assert "n = |r + D*n|" in shown
    assert " solve" not in shown


def test_a_report_shows_the_structure_of_what_is_iterated():
    shown = iterated().emit("latex")
    assert r"\rho n_A\Omega_A" in shown
    assert r"\left|r+Dn\right|" in shown
    assert shown.count("Newton") == 1
    assert r"\operatorname{sgn}" not in shown


def test_equations_that_are_short_are_printed_for_either_sense_of_motion():
    """The page gave n_A as a number that nobody could check."""
    found = compile_source(Source("coupler.mech", LOADED_COUPLER))
    shown = render(found.derivation, found.mechanism)
    ahead, back = (part.split() for part in re.findall(r"n_A(?:_hold)? = \|.*", shown))
    assert " ".join(ahead) == "n_A = |(AB − AC) / AB + ρ · n_A / (AB · cos ψ)|"
    assert " ".join(back) == "n_A_hold = |(AB − AC) / AB − ρ · n_A_hold / (AB · cos ψ)|"
    assert "|r + " not in shown
    assert shown.count("Newton") == 1


TRANSLATING = """
param r = 8 mm
pivot O
slider K along y
link AOB
link BK
OA = 150 mm @ 180 deg
OB = 60 mm @ 0 deg
BK = 30 mm @ 80 deg
force Q at A along -y
force P at K along -y
friction pins 0.15 diameter 2*r
find k = Q/P
"""


def test_where_a_rod_does_not_turn_on_a_pin_its_force_goes_through_the_middle_of_it():
    """B and K both move upwards: two friction circles had an external tangent, askew."""
    found = compile_source(Source("lever.mech", TRANSLATING))
    page = " ".join(render(found.derivation, found.mechanism).split())
    assert "The force in BK touches the friction circle of the pin B and goes through" in page
    assert "tangent" not in page


def test_it_is_said_what_the_force_of_teeth_is_and_whether_friction_changes_it():
    """A clutch is pressed by W alone; the force of one pair of gears rests on the next pair."""
    train = gear_train("friction gear O1 0.03", "friction gear O2 0.03")
    pages = [
        " ".join(render(found.derivation, found.mechanism).split())
        for found in (begun("plate_clutch"), compile_source(Source("train.mech", train)))
    ]
    known, on_others = "which friction does not change", "under the loads and the friction forces"
    teeth = "In gears, belts and racks n is the force that is passed on, and v is the velocity"
    assert [[words in page for words in (known, on_others, teeth)] for page in pages] == [
        [True, False, False],
        [False, True, True],
    ]


@pytest.mark.parametrize("language", ["en", "uk"])
def test_a_ratio_without_a_name_is_on_no_page_by_its_name_in_code(language):
    """The page had M_over_F_f, an English word among the letters."""
    unnamed = LOADED_COUPLER.replace("find k = M/F", "find M/F")
    found = compile_source(Source("coupler.mech", unnamed))
    page = " ".join(render(found.derivation, found.mechanism, language=language).split())
    assert "over" not in page
    assert "(M/F)_f = " in page
    assert "η_(M/F) = (M/F)/(M/F)_f" in page
    written = mechc.loads(unnamed).emit("latex", language=language)
    assert "over" not in written.partition(r"\begin{document}")[2]


def test_letters_of_what_is_iterated_are_no_names_of_the_description():
    """A crank of radius r, or a point D, is on the same page."""
    for written, equation in (
        (ITERATED, "n = |r + Dn|"),
        (ITERATED.replace("f_p", "r"), "n = |q + Dn|"),
    ):
        found = compile_source(Source("crank.mech", written))
        assert equation in " ".join(render(found.derivation, found.mechanism).split())


def test_json_gives_the_conditions_of_a_case():
    import json

    document = json.loads(loaded("karpenko_fig1_with_friction").emit("json"))
    found = next(r for r in document["results"] if r["name"] == "k_f")
    assert [c["operator"] for c in found["holds"]] == [">"]
    account = next(a for a in document["derivation"]["accounts"] if a["results"] == ["k_f"])
    assert [p["says"] for p in account["passages"]] == [
        "tightening",
        "pin friction",
        "rod forces",
        "part",
        "unit and drive",
        "pressed",
        "crossed",
        "turns left",
        "squared",
        "along",
    ]


# ------------------------------------------------------------------------- reports


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("karpenko_fig2_with_friction", r"Friction in the pins $A$ and $B$"),
        ("karpenko_fig2_with_friction", r"Friction in the pin $O$: the radius"),
        ("fedoriv_fig2b_with_friction", r"guide of $C$: reduced coefficient"),
        ("d45_16_wedge_hook_with_friction", r"coefficient $\tan\rho$"),
        ("screw_jack_with_friction", r"mean diameter $d$"),
        ("table_4_4_gear_with_efficiency", r"The efficiency is $\eta$"),
    ],
)
def test_friction_is_among_what_is_given(name, said):
    given = loaded(name).emit("latex").partition("begin{longtable}")[0]
    assert said in given
    assert re.search(r"With friction the motion is (along|against) the arrow of \$\w\$", given)


@pytest.mark.parametrize(
    ("language", "tightening", "releasing", "first"),
    [
        ("en", "$P$ drives", "$P$ is back-driven", "to first order"),
        (
            "uk",
            "прямий хід (рушійна сила $P$)",
            "зворотний хід (сила $P$ утримує)",
            "перше наближення",
        ),
        (
            "ru",
            "прямой ход (движущая сила $P$)",
            "обратный ход (сила $P$ удерживает)",
            "первое приближение",
        ),
    ],
)
def test_headings_set_results_with_friction_apart(language, tightening, releasing, first):
    shown = loaded("karpenko_fig2_with_friction").emit("latex", language=language)
    assert rf"{tightening} ($k_f$):}}" in shown
    hold = {"en": r"\mathrm{hold}", "uk": r"\text{утр}", "ru": r"\text{уд}"}[language]
    assert f"{releasing} ($k_{{{hold}}}$):}}" in shown
    assert f"{first} ($k_{{f1}}$):" in shown


@pytest.mark.parametrize(
    ("language", "said"),
    [
        (
            "uk",
            [
                "рух відбувається в напрямку моменту $T$",
                "прямий хід (рушійний момент $T$)",
                "зворотний хід (рушійний момент $T$)",
                "проти стрілки моменту $T$: за наведених значень механізм самогальмівний",
                "тому у зворотний бік його рухає сам момент $T$",
                "Самогальмування: сила $N$ сама не може",
            ],
        ),
        (
            "ru",
            [
                "движение происходит в направлении момента $T$",
                "прямой ход (движущий момент $T$)",
                "обратный ход (движущий момент $T$)",
                "против стрелки момента $T$: при приведённых значениях механизм самотормозящий",
                "поэтому в обратную сторону его движет сам момент $T$",
                "Самоторможение: сила $N$ одна не может",
            ],
        ),
    ],
)
def test_a_couple_that_drives_is_a_moment(language: str, said: list[str]) -> None:
    shown = loaded("d45_11_screw_lever_with_friction").emit("latex", language=language)
    assert [sentence for sentence in said if sentence not in shown] == []


@pytest.mark.parametrize(("language", "said"), [("uk", "Момент:"), ("ru", "Момент:")])
def test_a_couple_that_is_asked_for_is_headed_as_one(language: str, said: str) -> None:
    assert rf"\textbf{{{said}}}" in loaded("band_brake").emit("latex", language=language)


@pytest.mark.parametrize(
    ("loads", "word"),
    [(["P"], "сила"), (["T"], "момент"), (["P", "T"], "навантаження"), ([], "навантаження")],
)
def test_words_on_a_load_agree_with_what_it_is(loads: list[str], word: str) -> None:
    forms = LoadWords(loads, frozenset({"T"}))
    assert f"{forms:сила|момент|навантаження}" == word


def derived(name):
    compilation = compile_source(read(find(name)))
    return render(compilation.derivation, compilation.mechanism)


def test_the_force_in_a_pulled_rod_is_a_pull():
    """Table 1 row 2: the rod pulls the jaws together with k_f/2 over the cosine of its line."""
    shown = derived("karpenko_fig2_with_friction")
    assert "The rod AB is in tension." in shown
    assert "k_f = 2S_AB · cos(α − δ_AB)" in shown
    assert "−2" not in shown


def test_like_terms_of_the_first_order_are_one():
    """The rod slips at A with half the rotation that it has at B: 1/4 + 1/2 of b·f·d/a²."""
    assert "3bf · d / (4a² · sin² α)" in derived("karpenko_fig2_with_friction")


def test_a_thread_is_derived_from_its_force():
    """Shigley: what presses the thread is N/(1 − tan ψ·tan ρ) when the load is raised."""
    shown = derived("screw_jack_with_friction")
    assert "n_A_screw − n_A_screw · tan ψ · tan ρ = 1" in shown
    assert "T = d · tan ψ / 2 + n_A_screw · v_A_screw · tan ρ" in shown


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", "In a thread {} is the axial component of the normal force, and v is"),
        ("ru", "В резьбе {} — осевая составляющая нормальной силы, v — скорость скольжения"),
        ("uk", "У різьбі {} — осьова складова нормальної сили, v — швидкість ковзання"),
    ],
)
def test_the_force_of_a_thread_is_no_normal_force_but_its_axial_component(language, said):
    """N = n/cos ψ presses the flank, which slips at v·cos ψ: of both only the product is right."""
    found = compile_source(read(find("screw_jack_with_collar")))
    shown = " ".join(render(found.derivation, found.mechanism, language=language).split())
    assert said.format("n") in shown
    assert said.format("r") in shown


def test_an_efficiency_that_is_given_is_put_in():
    assert "n_f = nη" in derived("d45_12_worm_sectors_with_efficiency")


def test_an_efficiency_is_the_share_of_two_ratios():
    assert "η_k = k/k_f = " in derived("karpenko_fig2_with_friction")
    assert "η_i = i_f/i = " in derived("fedoriv_fig2b_with_friction")


def test_only_pairs_with_friction_are_explained():
    assert "friction circle" not in derived("d45_16_wedge_hook_with_friction").split("first")[0]
    assert "The friction in a pin" in derived("lever_clamp_with_friction")


def test_a_coefficient_with_sums_in_it_has_a_name():
    """A tilting plunger under a linear pressure: mu·(3l/s + s/(12l))."""
    source = """
param alpha = 30 deg in 10 deg .. 60 deg
param L = 80 mm
param mu = 0.12
param s = 40 mm
param l = 30 mm
slider B along -90 deg
slider C along 0 deg
link BC
BC = L @ -alpha
force Q at B along -90 deg
force W at C along 180 deg
friction slider C mu guide s overhang l linear
find k = Q/W
"""
    compilation = compile_source(Source("plunger.mech", source))
    shown = render(compilation.derivation, compilation.mechanism)
    assert "k_f = 1 / (cot α − μ_C)" in shown
    assert "μ_C = μ · (36l + s²/l) / (12s)" in shown


def test_a_force_with_friction_is_stated_once_under_a_heading_of_its_own():
    compilation = iterated()._compilation
    shown = render(compilation.derivation, compilation.mechanism)
    stated = shown.partition("Force at A on AB, with friction")[2]
    assert "This holds while" not in stated
    assert stated.count("This holds under the same conditions as k_f.") == 1
    assert "R_A_on_AB_f = √(R_A_on_AB_x_f² + R_A_on_AB_y_f²)" in stated


def test_joints_that_nothing_presses_have_no_friction_and_no_equations():
    text = follower("friction pin C 0.1 diameter 10 mm", "find R_C on QC")
    compilation = compile_source(Source("press.mech", text))
    shown = render(compilation.derivation, compilation.mechanism)
    stated = " ".join(shown.split())
    assert "Nothing presses the joints that have friction, so friction changes nothing." in stated
    assert "Newton" not in shown
    (held,) = (r for r in compilation.results if r.name == "k_f")
    (ideal,) = (r for r in compilation.results if r.name == "k")
    assert held.formula == ideal.formula


def test_what_is_long_multiplied_out_keeps_the_names_of_its_parts():
    """A lift of five joints: eight lines of sines otherwise, for each of four results."""
    source = find("scissor_table").read_text("utf-8")
    text = source + "\nparam f = 0.1\nfriction pins f diameter 20 mm\n"
    compilation = compile_source(Source("lift.mech", text))
    shown = " ".join(render(compilation.derivation, compilation.mechanism).split())
    assert "k_f = k + ρ · Ω_A_AMD · (n_A_AMD + n_B) + " in shown
    assert "k_f₁ = k + ρ · Ω_A_AMD · (r_A_AMD + r_B) + ρk · Ω_A_AE + " in shown
    assert "k_hold = k − ρ · Ω_A_AMD · (n_A_AMD_hold + n_B_hold)" in shown
    assert shown.count("Ω_A_AMD = ") == 2  # the definition, and its number
    assert "η_k = k/k_f - This holds while k > 0." in shown
    assert shown.count("under the same conditions as k_f.") == 1


def test_check_states_the_parts_of_a_force_once():
    lines = list(report(iterated()._compilation, verbose=False))
    assert "  R_A_on_AB_f = hypot(R_A_on_AB_x_f, R_A_on_AB_y_f)" in lines
    forces = lines[next(i for i, line in enumerate(lines) if "R_A_on_AB_x_f =" in line) :]
    assert sum("press the joints" in line for line in forces) == 1
    assert sum("holds while" in line for line in forces) == 1


# ------------------------------------------------------------------------- goldens


@pytest.mark.parametrize(
    "name",
    [
        "karpenko_fig2_with_friction",
        "fedoriv_fig2b_with_friction",
        "d45_11_screw_lever_with_friction",
        "lever_clamp_with_friction",
    ],
)
def test_derivation_golden(name, golden):
    golden(f"derivation/{name}.txt", derived(name))


@pytest.mark.parametrize("language", ["en", "uk", "ru"])
def test_report_golden(language, golden):
    shown = loaded("karpenko_fig2_with_friction").emit("latex", language=language)
    golden(f"latex/friction_{language}.tex", shown.partition("section*{")[2])


def test_the_force_on_a_face_has_one_name_and_angles_the_order_of_a_drawing():
    shown = derived("d45_16_wedge_hook_with_friction")
    assert "The whole force R_A of the face on A" in shown
    assert "P − R_A_hold · sin(β − ρ) = 0" in shown
    assert "N_A" not in shown


def test_slips_are_stated_of_joints_that_there_are():
    assert "rotation Ω" not in derived("d45_16_wedge_hook_with_friction")
    assert "speed v" not in derived("karpenko_fig2_with_friction")


def test_loads_of_unknown_size_are_not_taken_for_equal():
    """Two loads that would relieve a pin if they were equal: no case of H = W is printed."""
    source = """
param alpha = 20 deg in 5 deg .. 60 deg
param L = 80 mm
param f = 0.1
param d = 10 mm
pivot E
slider C along 0 deg
link EB
link BC
EB = L @ alpha
BC = L @ -alpha
force Q at B along -90 deg
force W at C along 180 deg
force H at B along 0 deg
friction pins f diameter d
find Q
"""
    compilation = compile_source(Source("toggle.mech", source))
    first = next(r for r in compilation.results if r.name == "Q_f1")
    assert first.holds
    assert all(condition.operator != "=" for condition in first.holds)


@pytest.mark.parametrize(
    "name",
    [
        "lever_clamp_with_friction",
        "d45_16_wedge_hook_with_friction",
        "fedoriv_fig2b_with_friction",
        "karpenko_fig9_with_friction",
    ],
)
def test_code_has_no_square_of_a_sign(name):
    code = loaded(name).emit("python")
    assert not re.search(r"\b((s|sigma)_\w*)(\*\*2|\*\1\b)", code)


def test_what_follows_from_no_equation_is_not_said_to_follow():
    """M_f1 = M_f is what the sentence above says; no "hence" begins after its full stop."""
    page = loaded("plate_clutch").emit("latex")
    first = page.partition("to first order")[2].partition(r"\boxed{M_{f1}")[0]
    assert "gives the same" in first
    assert "hence" not in first


# ---------------------------------------------------------------- which load drives

CRANK = """
{more}
pivot O
slider B along x
link OA
link AB
OA = {arm} @ {phi}
AB = 120 mm @ -10 deg
torque M on OA
force F at B along x
{friction}
find k = M/F
"""

PINS = "friction pins 0.1 diameter 10 mm"


def crank(phi: str, friction: str = PINS, arm: str = "40 mm", more: str = "") -> Source:
    return Source("crank.mech", CRANK.format(phi=phi, friction=friction, arm=arm, more=more))


def headings(source: Source, language: str) -> str:
    compiled = compile_source(source)
    return render(compiled.reported, compiled.mechanism, language=language, unicode=False)


@pytest.mark.parametrize(
    ("language", "drives", "held", "opening"),
    [
        ("en", "M drives", "M is back-driven", "along the arrow of M, which is negative"),
        (
            "uk",
            "прямий хід (рушійний момент M)",
            "зворотний хід (момент M утримує)",
            "за стрілкою моменту M, але за наведених значень він від’ємний",
        ),
        (
            "ru",
            "прямой ход (движущий момент M)",
            "обратный ход (момент M удерживает)",
            "по стрелке момента M, но при приведённых значениях он отрицателен",
        ),
    ],
)
def test_headings_say_who_drives_where_a_ratio_is_negative(language, drives, held, opening):
    """A couple is negative where it acts clockwise: then the load drives the motion along it."""
    before, after = (headings(crank(phi), language) for phi in ("120 deg", "240 deg"))
    assert f"{drives} (k_f)" in before
    assert f"{held} (k_hold)" in before
    assert f"{held} (k_f)" in after
    assert f"{drives} (k_hold)" in after
    assert opening in " ".join(after.split())
    assert opening not in " ".join(before.split())


@pytest.mark.parametrize(
    ("language", "heading", "opening"),
    [
        ("en", "With friction, P drives (n_f)", "P drives, and the motion is against"),
        ("uk", "прямий хід (рушійна сила P) (n_f)", "Рушійна сила — P, рух"),
        ("ru", "прямой ход (движущая сила P) (n_f)", "Движущая сила — P, движение"),
    ],
)
def test_of_a_ratio_whose_lower_load_drives_that_is_named(language, heading, opening):
    """A gripper's N/P with ``motion releasing``: nobody says of the jaw that it is back-driven."""
    found = compile_source(read(find("d45_06_double_wedge_with_friction")))
    shown = render(found.derivation, found.mechanism, language=language, unicode=False)
    assert heading in shown
    assert opening in " ".join(shown.split())
    assert "back-driven" not in shown


@pytest.mark.parametrize(("phi", "driven"), [("120 deg", False), ("240 deg", True)])
def test_json_says_whether_a_load_is_driven(phi, driven):
    import json

    document = json.loads(mechc.loads(crank(phi).text).emit("json"))
    found = {r["name"]: r["driven"] for r in document["results"]}
    assert found == {
        "k": None,
        "k_f": driven,
        "k_f1": driven,
        "k_hold": not driven,
        "eta_k": driven,
    }


def test_where_no_value_and_no_proof_gives_a_sign_neither_load_is_said_to_drive():
    """With a range the sign may be proved; at a dead centre there is none."""
    turned = crank("phi", more="param phi: angle")
    assert "the motion along the arrow of M (k_f)" in headings(turned, "en")
    proved = crank("phi", more="param phi: angle in 200 deg .. 300 deg")
    assert "M is back-driven (k_f)" in headings(proved, "en")
    assert "the motion against the arrow of M (k_hold)" in headings(crank("170 deg"), "en")


def test_a_given_efficiency_multiplies_a_ratio_that_is_proved_to_be_negative():
    """Without any length the load is known to drive: k_f is k times 0.8, not k over 0.8."""
    source = crank("240 deg", "efficiency 0.8", "r", "param r: length")
    compiled = compile_source(source)
    k, k_f = compiled.results
    assert evaluate(k_f.formula, {"r": 1.0}) == pytest.approx(0.8 * evaluate(k.formula, {"r": 1.0}))
    assert "M is back-driven (k_f)" in headings(source, "en")


def test_of_a_ratio_that_is_proved_to_be_negative_the_smaller_force_arrives():
    found = mechc.loads(crank("240 deg", PINS, "r", "param r: length").text).evaluate(r=0.04)
    assert found["eta_k"] == pytest.approx(found["k_f"] / found["k"])


@pytest.mark.parametrize(
    ("name", "is_said"), [("screw_jack_with_friction", False), ("claw_with_friction", True)]
)
def test_what_textbooks_assume_of_joints_is_said_of_joints(name, is_said):
    compilation = compile_source(read(find(name)))
    shown = " ".join(render(compilation.derivation, compilation.mechanism).split())
    assert "η_k runs from" in shown
    assert ("oiled joints" in shown) == ("between 0.9 and 0.95" in shown) == is_said


@pytest.mark.parametrize(
    ("name", "lines"),
    [
        (
            "band_brake",
            [
                "S_O_rope = P*l/a",
                "M_f = S_O_rope*v_O_rope*(exp(3*pi*mu/2) - 1)",
                "S_O_rope_hold*exp(3*pi*mu/2) = P*l/a",
                "M_hold = -S_O_rope_hold*v_O_rope*(exp(3*pi*mu/2) - 1)",
            ],
        ),
        ("cable_over_drum", ["S_B_rope = 1", "P = 1 + S_B_rope*v_B_rope*(exp(pi*mu/2) - 1)"]),
    ],
)
def test_friction_of_a_rope_is_the_difference_of_its_tensions(name, lines):
    """As a textbook has it, T₁ = T₂·e^(μθ) and M = (T₁ - T₂)·D/2: no mean that counts as normal."""
    text = headings(read(find(name)), "en")
    shown = "".join(text.split())
    assert all("".join(line.split()) in shown for line in lines)
    assert "The mean of" not in text.split("to first order")[0]


def test_what_an_account_has_found_is_shown_again_only_with_a_text():
    """Fedoriv's β = arcsin(2ρ/L) stands in the account; f_r comes again, as it has a text."""
    text = headings(read(find("fedoriv_fig2d_with_friction")), "en")
    account, further = text.split("Further quantities")
    assert "beta = asin(2*rho/L)" in account
    assert "beta" not in further.split("Numerical")[0]
    assert "f_r = 3*l*f2/A" in further


def test_what_is_equal_to_an_earlier_speed_keeps_its_name():
    """Both nuts of two screws slide alike: v_B = v_A is no other speed than before."""
    shown = derived("d45_10_two_screws_with_friction")
    assert "v_B_screw = v_A_screw" in shown
    assert "v_B_screw_f" not in shown


def test_a_result_does_not_repeat_the_line_before_it():
    """``hence`` stood between two lines that were the same but for the order of letters."""
    found = compile_source(Source("drum.mech", DRUM.format(way=200)))
    page = " ".join(render(found.derivation, found.mechanism, unicode=False).split())
    assert "in the pivot): M_hold = -F*rho" in page


def test_an_equation_stands_once():
    (forces,) = re.findall(
        "in the direction x:\n(.*?)\n +N_A is", derived("cabinet_on_casters"), re.S
    )
    assert forces.split() == ["P", "=", "0"]


DRUM = """
param f = 0.1
pivot O
link OA
OA = 50 mm @ 20 deg
torque M on OA
force F at A along {way} deg
friction pins f diameter 40 mm
find M
let F = 300 N
"""


@pytest.mark.parametrize(
    ("way", "balance"),
    [
        (200, ["M_f = rho*F", "M_f = F*rho", "M_hold = -F*rho"]),
        (
            120,
            [
                "M_f + F * len_OA * sin(80 deg) = rho*F",
                "M_hold + F * len_OA * sin(80 deg) = -rho*F",
            ],
        ),
    ],
)
def test_a_load_has_its_own_name_in_the_balance_with_friction(way, balance):
    """M is what it is without friction, as the page states above."""
    compilation = compile_source(Source("drum.mech", DRUM.format(way=way)))
    shown = render(compilation.reported, compilation.mechanism, unicode=False)
    lines = [" ".join(line.split()) for line in shown.splitlines()]
    assert [line for line in lines if line in balance] == balance
    assert "M_f1 = M + rho * r_O" in lines  # the drive itself turns in O
    assert not any(line.startswith(("M + F", "M = rho", "M = -rho")) for line in lines)


@pytest.mark.parametrize(
    "name",
    [
        "karpenko_fig3_with_friction",
        "karpenko_fig4_with_friction",
        "karpenko_fig9_with_friction",
        "tongs_fig4_9_with_friction",
    ],
)
def test_angles_of_friction_stand_behind_those_of_the_drawing(name):
    """An equation had cos(θ − δ), the root of it cos(δ − θ), and numbers sin²(−38.854°)."""
    text = loaded(name).emit("latex")
    assert not re.search(r"[({]\\delta_\{[A-Z]{2}\}-", text)
    assert "(-" not in text.partition("Numerical values")[2]


def test_what_a_lever_is_solved_by_has_a_positive_arm():
    """The quadratic of the lifting tongs had −a sin(2θ − δ) − ρ for an arm, and −b cos α beside."""
    found = compiled("karpenko_fig4_with_friction")
    (k_hold,) = (r for r in found.derivation.results if r.name == "k_hold")
    where = dict(k_hold.where)
    assert text(where["a_AB_hold"]) == "rho_A + a*sin(2*theta - delta_AB)"
    assert "b_AB_hold" not in where
    assert all(condition.operator == ">" for condition in k_hold.holds)
    (arm,) = (h.left for h in k_hold.holds if isinstance(h.left, Sum) and len(h.left.terms) == 3)
    assert text(arm) == "rho_A + a*sin(2*theta - delta_AB) - rho_O"


def test_what_is_alike_is_so_by_name_and_what_is_known_is_not_stated_again():
    text = loaded("d45_10_two_screws_with_friction").emit("latex")
    account = text.partition("The motion is along the arrow")[2].partition("Numerical")[0]
    assert account.count(r"n_{B,\mathrm{screw}}&=n_{A,\mathrm{screw}}") == 1
    first, _, hold = account.partition("The motion is against the arrow")
    assert first.count(r"v_{B,\mathrm{screw}}&=v_{A,\mathrm{screw}}") == 2
    assert r"v_{A,\mathrm{screw}}&=" not in hold


def test_an_account_of_friction_has_the_angles_of_the_result() -> None:
    """The rod's sine is that of k, 60° − β − φ, also where an inclination is an arc sine."""
    source = """
    mechanism gripper
    param phi = 10 deg
    pivot O at (20 mm, 0 mm)
    pivot Q at (20 mm, 25 mm)
    slider S along x through N
    pivot N at (0 mm, 0 mm)
    link SA
    link AOB
    link QC
    link BCJ
    OA = 30 mm @ 120 deg + phi
    OB = 70 mm @ phi
    QC = 70 mm @ phi
    BC = 25 mm @ 90 deg
    CJ = 40 mm @ 0 deg
    SA = 45 mm
    drive phi from -20 deg to 30 deg
    mirror across x sharing S
    force P at S along x
    force F at J along y
    friction pins 0.1 diameter 10 mm
    find k = P/F
    """
    found = compile_source(Source("gripper.mech", source))
    said = render(found.derivation, found.mechanism)
    assert "k = P/F = 2 · OB / OA · cos β_SA · cos φ / sin(60° − β_SA − φ)" in said
    assert "r_S = OB/OA · cos φ / sin(60° − β_SA − φ)" in said
    assert "cos(β_SA + φ + 30°)" not in said


@pytest.mark.parametrize("contact", ["", "friction contact A 0.1"])
def test_the_force_of_a_slot_is_introduced(contact: str) -> None:
    """R_A stood in the moments without a word; with friction there it is turned from the normal."""
    geneva = f"""
    mechanism geneva
    param phi = -20 deg
    pivot O at (0 mm, 0 mm)
    pivot Q at (100 mm, 0 mm)
    link OA
    link QC
    slot A in QC
    OA = 70 mm @ phi
    QC = 80 mm
    drive phi from -40 deg to 40 deg
    torque M on OA
    torque T on QC
    friction pins 0.1 diameter 10 mm
    {contact}
    find k = M/T
    """
    found = compile_source(Source("geneva.mech", geneva))
    said = " ".join(render(found.derivation, found.mechanism).split())
    assert said.count("R_A is the force of QC on A, along the normal.") == (not contact)
    assert ("The whole force R_A of the face on A" in said) == bool(contact)


def test_no_condition_begins_with_a_minus() -> None:
    """−sin(μ_B − δ_AB) < 0 is stated as sin(μ_B − δ_AB) > 0."""
    press = """
    mechanism press
    pivot O at (0 mm, 0 mm)
    pivot C at (300 mm, 250 mm)
    slider F along y
    link OA
    link AB
    link CB
    link BF
    A at (40 mm, 30 mm)
    B at (290 mm, 20 mm)
    F at (300 mm, -210 mm)
    drive OA from 0 deg to 360 deg
    torque M on OA
    force R at F along y
    friction pins 0.08 diameter 40 mm
    friction slider F 0.1
    find k = M/R
    """
    found = compile_source(Source("press.mech", press))
    said = " ".join(render(found.derivation, found.mechanism).split())
    conditions = re.findall(r"This holds while ([^.]*)\.", said)
    assert any("sin(μ_B − δ_AB) > 0" in each for each in conditions)
    assert not any(part.startswith("−") for each in conditions for part in each.split(", "))


def test_what_friction_divides_by_is_positive() -> None:
    """k_hold had μ·sin(β + δ) − cos(β + δ) below the line, an arm −sin(φ_AB − δ_AB − φ_CB)."""
    crank = """
    mechanism crank
    param r = 60 mm
    param l = 200 mm
    param mu = 0.1
    param phi = 60 deg in 0 deg .. 360 deg
    pivot O
    slider B along x through O
    link OA
    link AB
    OA = r @ phi
    AB = l
    drive phi from 10 deg to 170 deg
    assembly B forward
    torque M on OA
    force F at B along -x
    friction pins 0.12 diameter 30 mm
    friction slider B mu
    find k = M/F
    """
    found = compile_source(Source("crank.mech", crank))
    said = " ".join(render(found.derivation, found.mechanism).split())
    assert "k_hold = −(r · sin(β_AB + δ_AB + φ) + 2ρ) / (cos(β_AB + δ_AB) − μ ·" in said
    cutter = """
    mechanism cutter
    pivot C at (0 mm, 0 mm)
    slider A along y
    link AB
    link CBE
    A at (-75 mm, 0 mm)
    B at (-60 mm, 20 mm)
    E at (300 mm, 60 mm)
    force N at A along -y
    force P at E along -y
    friction pins 0.12 diameter 10 mm
    find k = P/N
    """
    found = compile_source(Source("cutter.mech", cutter))
    said = render(found.derivation, found.mechanism)
    assert "b_P = CB · sin(δ_AB + φ_CB − φ_AB) / sin(φ_AB − δ_AB)" in said


LEVERS = """
pivot O at (1 m, -2 m)
pivot C at (0 m, 2 m)
A at (4 m, 2 m)
B at (0 m, 3 m)
D at (2 m, -1 m)
link OA
link AB
link CBD
torque M on OA
force F at D along -y
friction pins 0.1 diameter 500 mm
find k = F/M, R_C
"""


def test_a_load_has_one_name_without_friction_and_another_with_it():
    made = compile_source(Source("levers.mech", LEVERS))
    shown = render(made.reported, made.mechanism, unicode=False)
    ideal, with_friction = shown.split("Force at C, with friction")
    assert "F_f" not in ideal
    assert "F_f is the value of F with friction." in with_friction
    assert not re.search(r"\bF\b", with_friction.partition("with friction.")[2])


def test_a_friction_by_itself_depends_on_no_others() -> None:
    """Of one pin there is one force, and an equation, where two pins make a system."""
    found = compile_source(Source("coupler.mech", LOADED_COUPLER))
    page = " ".join(render(found.derivation, found.mechanism).split())
    assert "depends on a force that it changes itself" in page
    assert "The force n follows likewise." in page
    assert "on the others" not in page


TOGGLE = """
param alpha = 15 deg in 3 deg .. 40 deg
pivot O at (0 mm, 0 mm)
slider K along y through O
link OB
link BK
OB = 200 mm @ -90 deg - alpha
BK = 200 mm
assembly K back
force P at B along {way}
force F at K along y
friction pins 0.1 diameter 30 mm
friction slider K 0.1
find k = P/F
find R_O
{value}
"""


def toggle(value="let F = 3 kN", way="x"):
    compilation = compile_source(Source("toggle.mech", TOGGLE.format(value=value, way=way)))
    shown = render(compilation.reported, compilation.mechanism, unicode=False)
    return [" ".join(line.split()) for line in shown.splitlines()]


def test_forces_found_per_unit_of_the_only_load_are_multiplied_by_it():
    """The quadratic equation for P is not solved once more, with F in it."""
    lines = toggle()
    start = lines.index("Force at O, with friction")
    assert lines[start + 1 : start + 10] == [
        "P_f is the value of P with friction.",
        "The forces found above per unit of F are multiplied by F.",
        "S_BK_f = F * S_BK",
        "P_f = F * k_f",
        "The force on OB at O balances all other forces on it:",
        "R_O_x_f = S_BK_f * sin(alpha + delta_BK) - P_f",
        "R_O_y_f = -S_BK_f * cos(alpha + delta_BK)",
        "R_O_f = sqrt(R_O_x_f^2 + R_O_y_f^2)",
        "phi_R_O_f = atan2(R_O_y_f, R_O_x_f)",
    ]
    assert "P_f = 3 kN * 0.584799 = 1.7544 kN" in lines
    assert "S_BK_f = 3 kN * 1.06997 = 3.20991 kN" in lines
    assert "R_O_x_f = 3.20991 kN * sin(15.8595 deg) - 1.7544 kN = -0.877199 kN" in lines


def test_what_is_per_unit_has_no_number_where_the_load_has_none():
    assert not [line for line in toggle("") if line.startswith("S_BK = ") and line[-1].isdigit()]


def test_a_drive_that_is_negative_is_said_to_act_against_its_arrow():
    """The arrow of P points the other way: along it the press opens, and P only slows that."""
    shown = " ".join(toggle("", way="-x"))
    assert "along the arrow of P, which is negative at the values given: it only just" in shown
    assert "against the arrow of P, which is negative at the values given and so drives" in shown


FOUR_BAR = """
param phi = 60 deg in 30 deg .. 100 deg
pivot O at (0 mm, 0 mm)
pivot C at (120 mm, 0 mm)
link OA
link AB
link CBD
OA = 30 mm @ phi
AB = 100 mm
CB = 80 mm
CD = 140 mm @ CB
assembly ABC cw
drive phi from 30 deg to 100 deg
torque M on OA
force F at D along perp BC
friction pins 0.1 diameter 12 mm
find k = M/F
find R_C
find R_O
"""


def test_a_force_that_a_quadratic_equation_gives_is_found_once():
    """S_AB, per unit of F, is its root; what the pivots carry rests on it, times F."""
    compilation = compile_source(Source("press.mech", FOUR_BAR))
    shown = render(compilation.reported, compilation.mechanism, unicode=False)
    assert shown.count("S_AB_f = ") == 1
    assert "S_AB_f = F * S_AB\n" in shown
    assert shown.count("Squaring gives a quadratic equation") == 2  # of k_f and of k_hold
    assert "R_O_f = S_AB_f\n" in shown
