"""How forces at joints come about: every equation that is printed holds with numbers put in."""

import pytest

from good_mechanisms import begun
from mechc.compilation import compile_source
from mechc.files import find, library, read
from mechc.formula.evaluate import evaluate
from mechc.formula.tree import Power, Product, Symbol
from mechc.formula.walk import symbols
from mechc.model.parts.targets import Efficiency, WithFriction
from mechc.power.numbers import default_values
from mechc.report.derivation.forces import of_forces
from mechc.report.kinds import SentenceKind
from mechc.report.text.derivation import render
from mechc.source import Source

TOGGLE = """
param alpha = 20 deg
param L = 80 mm
pivot E
slider C along 0 deg
link EB
link BC
EB = L @ alpha
BC = L @ -alpha
force Q at B along -90 deg
force W at C along 180 deg
find k = Q/W
"""

DESCRIPTIONS = {
    "toggle": TOGGLE + "find R_E\nfind N_EB\nfind N_BC\nfind R_B on BC\nfind N_C\nfind R_C",
    "packet clamp": ("karpenko_fig9_packet_clamp", "find R_O\nfind R_B on OBA\nfind R_K on BK"),
    "parallel levers": ("karpenko_fig1_parallel_levers", "find R_O\nfind R_B on AB"),
    "shears": ("bolt_cutter", "find R_D\nfind R_H on HGE"),
    "crank": ("crank_rocker", "find R_O1\nfind N_AB"),
    "slot": ("d45_07_lever_slot", "find R_O"),
    "whitworth": ("whitworth", "find R_Q\nfind R_E\nfind R_O"),
    "excavator": ("excavator_arm", "find R_O\nfind R_C"),
}


def compiled(name):
    found = DESCRIPTIONS[name]
    if isinstance(found, str):
        return compile_source(Source("toggle.mech", found))
    source = read(find(found[0]))
    return compile_source(Source(source.name, f"{source.text}\n{found[1]}\n"))


def numbers(compilation, account):
    """Return the values at the default pose of all that a printed equation may mention."""
    values = default_values(compilation.plan)
    values |= {load.name: 1.0 + i / 7 for i, load in enumerate(compilation.mechanism.loads)}
    results = {r.name: r for r in compilation.results}
    where = [*account.where, *(d for name in account.results for d in results[name].where)]
    for definition in where:
        values[definition.name] = evaluate(definition.formula, values)
    for name in account.results:
        values[name] = evaluate(results[name].formula, values)
    return values


@pytest.mark.parametrize("name", DESCRIPTIONS)
def test_the_power_of_a_released_constraint(name):
    """The ratios of speeds, put into the power equation, give the force that was found."""
    compilation = compiled(name)
    checked = 0
    for account in of_forces(compilation.solution):
        values = numbers(compilation, account)
        for paragraph in account.paragraphs:
            if "speed" not in paragraph.formulas:
                continue
            values[paragraph.formulas["speed"].name] = 1.0
            *ratios, power = (e for e in paragraph.equations if not isinstance(e.left, Symbol))
            for found in (e for e in paragraph.equations if isinstance(e.left, Symbol)):
                values[found.left.name] = evaluate(found.right, values)
            for ratio in ratios:
                values[speed_in(ratio.left)] = evaluate(ratio.right, values)
            assert evaluate(power.left, values) == pytest.approx(0, abs=1e-9)
            checked += 1
    assert checked


@pytest.mark.parametrize("name", DESCRIPTIONS)
def test_forces_at_joints_follow_from_sums_with_what_is_known(name):
    """Each printed sum holds, those of forces found before under their names."""
    compilation, values = compiled(name), {}
    for account in compilation.derivation.explanations:
        assert not any("speed" in paragraph.formulas for paragraph in account.paragraphs)
        known = numbers(compilation, account)
        held = {n for one in compilation.balance.solved for r in one.releases for n in r.held}
        values = {**values, **{n: value for n, value in known.items() if n not in held}}
        for equation in (e for p in account.paragraphs for e in p.equations):
            if isinstance(equation.left, Symbol):
                values.setdefault(equation.left.name, evaluate(equation.right, values))
                assert evaluate(equation.right, values) == pytest.approx(values[equation.left.name])
    for account in compilation.derivation.explanations:
        for equation in (e for p in account.paragraphs for e in p.equations):
            if symbols(equation.left) <= values.keys():
                sides = [evaluate(side, values) for side in equation]
                assert sides[0] == pytest.approx(sides[1], abs=1e-9)


def speed_in(ratio):
    match ratio:
        case Product((Symbol(name), Power())):
            return name
    raise AssertionError(ratio)


FORCES = ("Force at", "Force in", "Force of", "Normal force")


def shown(name):
    compilation = compiled(name)
    return render(compilation.derivation, compilation.mechanism)


def test_a_force_is_stated_under_one_heading_with_its_direction():
    text = shown("toggle")
    headings = [line for line in text.splitlines() if line.startswith(FORCES)]
    assert headings == [
        "Force at E",
        "Force in the rod EB",
        "Force in the rod BC",
        "Force at B on BC",
        "Normal force at C",
        "Force of the guide at C",
    ]
    assert "φ_R_E = atan2(R_E_y, R_E_x)" in text
    assert text.count("atan2(y, x) is the direction of the vector with the components") == 1
    assert "R_E = |W| / |cos α|" in text


def test_a_rod_without_loads_passes_on_what_was_found_along_its_line():
    compilation = compiled("toggle")
    accounts = {a.results[0]: a for a in compilation.derivation.explanations}
    on_rod = accounts["R_B_on_BC_x"]
    (paragraph,) = on_rod.paragraphs
    assert paragraph.sentence is SentenceKind.ROD
    assert [symbols(e.right) & {"N_BC"} for e in paragraph.equations] == [{"N_BC"}] * 2


def test_a_guide_presses_across_itself():
    accounts = compiled("toggle").derivation.explanations
    sideways = next(a for a in accounts if a.results[0] == "R_C_x")
    assert sideways.paragraphs[0].sentence is SentenceKind.SMOOTH


def test_results_mention_nothing_that_is_not_stated():
    compilation = compiled("packet clamp")
    known = {p.name for p in compilation.mechanism.parameters}
    known |= {load.name for load in compilation.mechanism.loads}
    for result in compilation.results:
        stated = known | {d.name for d in result.where}
        assert symbols(result.formula) <= stated


# ------------------------------------------------------------------------ friction

CASES = [name for name, path in library().items() if "\nfriction " in path.read_text("utf-8")]


@pytest.mark.parametrize("case", CASES)
def test_what_is_stated_of_friction_is_true(case):
    """Every equation holds at the default pose, with what the equations before it define."""
    compilation = begun(case)
    values = default_values(compilation.plan)
    values = {load.name: 1.0 for load in compilation.mechanism.loads} | values
    results = {r.name: r for r in compilation.results}
    values |= {name: r.default for name, r in results.items() if r.default is not None}
    stated = 0
    for account in compilation.derivation.explanations:
        target = results[account.results[0]].target
        if not isinstance(target, WithFriction | Efficiency):
            continue
        driving = getattr(target.of, "above", getattr(target.of, "load", ""))
        values[driving] = results[account.results[0]].default
        equations = [e for paragraph in account.paragraphs for e in paragraph.equations]
        for definition in (d for name in account.results for d in results[name].where):
            values[definition.name] = evaluate(definition.formula, values)
        defined = [e for e in equations if isinstance(e.left, Symbol)]
        for equation in defined:
            values[equation.left.name] = evaluate(equation.right, values)
        for left, right in equations:
            assert evaluate(left, values) == pytest.approx(evaluate(right, values), abs=1e-9)
        for name in account.results:
            found = evaluate(results[name].formula, values)
            assert found == pytest.approx(results[name].default, rel=1e-9)
        stated += len(equations)
    assert stated or not compilation.derivation.explanations


@pytest.mark.parametrize("case", CASES)
def test_no_sign_function_is_printed(case):
    compilation = begun(case)
    shown = render(compilation.derivation, compilation.mechanism)
    assert "sign(" not in shown
    assert "sigma" not in shown
