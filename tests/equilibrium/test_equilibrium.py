"""A load from free bodies, step by step: it is the one that virtual power gives, at any pose."""

from itertools import islice

import pytest

from good_mechanisms import ALL, begun
from mechc.cli import main
from mechc.compilation import Compilation
from mechc.equilibrium.equilibrium import Equilibrium
from mechc.formula.evaluate import evaluate
from mechc.model.mechanism import LoadForm, LoadRatio, Pivot, Slider
from mechc.model.values import completed
from mechc.power.loads import given_size
from mechc.source import Source
from mechc.statics.poses import candidates
from sources import in_thirds

EACH_JOINT = (
    "karpenko_fig9_packet_clamp",  # rods, a lever, halves
    "three_claw_gripper",  # copies
    "crank_rocker",  # a closed loop
    "whitworth",  # a pin in a slot
    "block_on_rocker",  # a link that slides along another
    "wedge_drive",  # contacts, halves
    "d45_14_parallelogram_jaw",  # a rack, lengths that are not given
    "d45_10_two_screws",
    "gear_train_teeth",
    "gear_on_coupler",  # wheels on an arm
    "arc_slot",
    "cartesian_rods",  # directions by components
    "equalising_clamp",  # two freedoms
    "triad_closed",  # sums that are solved together
    "tied_chain",
    "loads_on_links",
)
Loads = LoadRatio | LoadForm
BEYOND = {"roberval_balance"}
"""What bodies that hang together more closely keep from being found so."""


def agree(compilation: Compilation, poses: int) -> int:
    """Compare a mechanism's loads at some poses; return how many were compared."""
    mechanism, compared = compilation.mechanism, 0
    results = {s.result.name: s.result for s in compilation.balance.solved}
    held = {s.result.name: s.releases[0].held for s in compilation.balance.solved if s.releases}
    targets = {name: result.target for name, result in results.items()}
    for equilibrium in compilation.equilibrium:
        name, target = equilibrium.result, targets[equilibrium.result]
        for values in islice(candidates(compilation.pose, 3 * poses), poses):
            loads = sizes(mechanism, target, values)
            known = {n: size for n, size in loads.items() if n not in held.get(name, ())}
            forces = solved(equilibrium, known, values)
            formula, where = results[name].formula, results[name].where
            known = completed({**known, **values}, where)
            expected = pytest.approx(evaluate(formula, known), rel=1e-7, abs=1e-9)
            assert forces[equilibrium.load] == expected
            compared += 1
    return compared


def sizes(mechanism, target, values) -> dict[str, float]:
    """Return loads: those that are given as they are, others as they come; of a ratio one only."""
    if isinstance(target, LoadRatio):
        return dict.fromkeys([k.name for k in mechanism.loads], 0.0) | {target.below: 1.0}
    given = {k.name: given_size(mechanism, k.name) for k in mechanism.loads}
    free = {n: 1.0 + i for i, (n, f) in enumerate(given.items()) if f is None}
    return {n: evaluate(f, {**values, **free}) if f else free[n] for n, f in given.items()}


def solved(equilibrium: Equilibrium, loads, values) -> dict[str, float]:
    """Return the forces of the steps; a sum vanishes, unless it has one that is eliminated."""
    forces = {n: f for n, f in loads.items() if n != equilibrium.load}
    for step in equilibrium.steps:
        for name, terms in step.found:
            forces[name] = sum(part.evaluate(values) * forces[n] for n, part in terms.items())
        for balance in (b for b in step.balances if b.terms.keys() <= forces.keys()):
            parts = [p.evaluate(values) * forces[n] for n, p in balance.terms.items()]
            assert abs(sum(parts)) <= 1e-9 * max(map(abs, parts)), balance
    return forces


@pytest.mark.parametrize("name", EACH_JOINT)
def test_the_load_is_that_of_virtual_power(name):
    assert agree(begun(name), 3) > 0


FORCES = {
    "crank_rocker": ["R_O1_x", "R_O1_y", "N_AB", "N_O2B"],
    "vice_grip": ["R_O_x", "R_O_y", "N_BS"],
    "whitworth": ["R_O_x", "R_O_y", "R_Q_x", "R_Q_y", "N_DE"],
    "band_brake": ["R_O_x", "R_O_y", "N_OG"],  # its rope pulls at the pivot, a weight at the link
    "karpenko_fig4_lifting_tongs": ["N_AB", "R_O_x", "R_O_y"],  # halves share the pivot
    "copies_claw": ["N_KA", "R_O_x"],
    "loads_on_links": ["N_OB", "N_BC"],
}


@pytest.mark.parametrize("name", FORCES)
def test_forces_at_joints_are_those_of_virtual_power(name):
    text, mechanism = ALL[name].read_text(encoding="utf-8").rstrip(), begun(name).mechanism
    asked = [f"find R_{pivot.point}" for pivot in mechanism.each(Pivot)]
    asked += [f"find N_{link.name}" for link in mechanism.links if len(link.points) == 2]
    links = [(link.name, p) for link in mechanism.links for p in link.points]
    asked += [f"find R_{p} on {name}" for name, p in links if is_held(name, p, mechanism)]
    found = Compilation(Source(f"{name}.mech", "\n".join([text, *asked, ""])))
    at_joints = [each.result for each in found.equilibrium if each.is_at_joint]
    assert {*FORCES[name]} <= {*at_joints}
    assert agree(found, 2) >= len(at_joints)
    explained = [name for e in found.by_equilibrium.explanations for name in e.results]
    assert len(explained) == len({*explained})


def is_held(name, point, mechanism):
    """Return whether a link meets others at a point, or the ground."""
    others = [body for body in mechanism.bodies if body.name != name and point in body.points]
    return (
        bool(others)
        or point in mechanism.fixed
        or point in {g.point for g in mechanism.each(Slider)}
    )


@pytest.mark.parametrize(
    "name", in_thirds(["double_butterfly", "watt_closed", "tilted_gravity_linkage"])
)
def test_forces_at_pins_between_links_are_those_of_virtual_power(name):
    """One component pair each, as loops of several links have many."""
    text, mechanism = ALL[name].read_text(encoding="utf-8").rstrip(), begun(name).mechanism
    pins = [(k.name, p) for k in mechanism.links for p in k.points if is_held(k.name, p, mechanism)]
    found = Compilation(
        Source("m.mech", "\n".join([text, *(f"find R_{p} on {k}" for k, p in pins), ""]))
    )
    at_joints = {each.result for each in found.equilibrium if each.is_at_joint}
    assert {f"R_{p}_on_{k}_{axis}" for k, p in pins for axis in "xy"} <= at_joints
    assert agree(found, 1) >= len(at_joints)


def asks_for_load(name):
    return any(isinstance(find.target, Loads) for find in begun(name).mechanism.finds)


@pytest.mark.slow
def test_the_load_is_that_of_virtual_power_in_many_mechanisms():
    """Every third one, as all of them would take too long."""
    names = sorted({*ALL} - BEYOND - {*EACH_JOINT})[::3]
    compared = [agree(begun(n), 2) for n in names if asks_for_load(n)]
    assert sum(map(bool, compared)) > 30


def test_the_moment_centre_is_where_most_unknown_forces_pass():
    (equilibrium,) = begun("karpenko_fig9_packet_clamp").equilibrium
    assert [(b.body, b.centre, b.is_guide) for s in equilibrium.steps for b in s.balances] == [
        ("K", "", True),
        ("OBA", "O", False),
    ]
    assert [f.names for f in equilibrium.forces] == [("N_BK",)]
    assert equilibrium.parts == 2


def test_teeth_press_a_planet_where_they_mesh(capsys):
    """Its pin had no force at all: the teeth were couples, and two forces had one name."""
    compilation = begun("planetary_gear")
    assert agree(compilation, 3)
    assert main(["derive", str(ALL["planetary_gear"]), "--by", "equilibrium"]) == 0
    text = " ".join(capsys.readouterr().out.split())
    assert "R_A_n and R_A_t are the components, along OA and perpendicular to it" in text
    assert "T_OS − R_A_t + T_O = 0" in text
    assert "T_OS is the circumferential force between the wheels on OS and AP" in text
    assert "R_A_t = 0" not in text


@pytest.mark.parametrize("order", ["sun first", "planet first"])
def test_each_pair_of_a_planet_has_a_force_of_its_own(order):
    """Where the planet was named first both were T_AB, and T_AB was −T_AB."""
    text = ALL["planetary_ring"].read_text()
    if order == "planet first":
        text = text.replace("gear O m*z1/2 on OS, A m*z2/2", "gear A m*z2/2, O m*z1/2 on OS")
    compilation = Compilation(Source("p.mech", text))
    assert agree(compilation, 3)
    (equilibrium,) = compilation.equilibrium
    assert [f.names for f in equilibrium.forces if f.kind == "rim"] == [("T_OS",), ("T_O",)]


def test_a_pin_shared_with_a_crank_has_its_force_along_the_crank():
    compilation = begun("mirror_beam_torque")
    assert agree(compilation, 3)


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("toggle_clamp", "N_AB = −eF/a · cos θ / sin(φ_AB − θ − 60°)"),
        ("four_bar", "M − a · N_AB · sin(φ − ψ) = 0"),
    ],
)
def test_sums_have_the_sines_of_the_result(name, said, capsys):
    """One had cos(φ_AB − θ + 30°) for the sine in k, the other sin(ψ − φ)."""
    assert main(["derive", str(ALL[name]), "--by", "equilibrium", "--no-cache"]) == 0
    assert said in capsys.readouterr().out


@pytest.mark.parametrize("name", sorted(BEYOND))
def test_what_hangs_together_more_closely_is_refused(name, capsys):
    assert main(["derive", str(ALL[name]), "--by", "equilibrium"]) == 1
    out, err = capsys.readouterr()
    assert (out, "error[E730]" in err) == ("", True)
    assert main(["compile", str(ALL[name]), "--emit", "latex", "--by", "equilibrium"]) == 1


def test_velocities_do_not_follow_from_equilibrium(tmp_path, capsys):
    path = tmp_path / "m.mech"
    path.write_text(
        "mechanism m\nparam a = 1 m\nparam t = 20 deg\npivot O\nlink OAB\nOA = a @ t\n"
        "OB = 2*a @ t\nfind V_B/V_A\n"
    )
    assert main(["derive", str(path), "--by", "equilibrium"]) == 1
    assert "error[E731]" in capsys.readouterr().err


def test_a_sheet_has_no_bodies(tmp_path, capsys):
    path = tmp_path / "s.mech"
    path.write_text("sheet s\nparam a = 1 m\nlet b = 2*a\n")
    for command in (["derive"], ["compile", "--emit", "latex"]):
        assert main([*command, str(path), "--by", "equilibrium"]) == 1
        assert "error[E704]" in capsys.readouterr().err


CLAMP = {
    "en": """
     Each body is in equilibrium under all that acts on it.
     By symmetry one of the equal parts is considered; on what they share all of
     them act.
     N_BK is the force in the rod BK, positive in tension.
     Forces on K along its guide:
        2N_BK · cos β + F = 0
                     N_BK = −F / (2 · cos β)
     Moments about O of the forces on OBA:
        a · N_BK · sin(α + β) + bP · cos α = 0
                                         P = −a · N_BK / b · sin(α + β) / cos α
     hence
        k = P/F = a/(2b) · sin(α + β) / (cos α · cos β)
""",
    "uk": "     N_BK — зусилля в стрижні BK, додатне при розтягу.\n",
    "ru": "     N_BK — усилие в стержне BK, положительное при растяжении.\n",
}


@pytest.mark.parametrize("language", CLAMP)
def test_the_steps_are_written_as_on_paper(language, capsys):
    path = str(ALL["karpenko_fig9_packet_clamp"])
    assert main(["derive", path, "--by", "equilibrium", "--lang", language]) == 0
    assert CLAMP[language] in capsys.readouterr().out


def test_a_report_has_sums_and_no_velocities(capsys):
    path = str(ALL["whitworth"])
    assert main(["compile", path, "--emit", "latex", "--by", "equilibrium"]) == 0
    text = capsys.readouterr().out
    assert r"\section*{Velocities}" not in text
    assert r"\section*{Position}" in text
    assert "Moments about $Q$ of the forces on $QCD$:" in text


def test_what_is_found_for_one_load_is_not_stated_again_for_the_next():
    text = """
        mechanism m
        param a = 1 m
        pivot O
        link OAB
        OA = a @ 0 deg
        OB = 2*a @ 0 deg
        force P at A along y
        force F at B along -y
        find P
        find k = P/F
    """
    compilation = Compilation(Source("m.mech", text))
    stated = [len(e.paragraphs) for e in compilation.by_equilibrium.explanations]
    assert stated == [2, 0]


PUSHED_ON_A_GUIDE = """
pivot A
link AC
param t = -108.9 deg in -120 deg .. -90 deg
AC = 119.6 mm @ t
slider D along -69.7 deg
link CD
CD = 122.8 mm @ 55.6 deg
pivot E
contact D on EG normal 248.8 deg
link EG
EG = 83.8 mm @ -131.9 deg
ED = 50.5 mm @ -31.6 deg
torque P on AC
force F at G along -157.2 deg
find k = P/F
find R_D
"""

IN_TWO_SLOTS = """
param t = 40 deg in 30 deg .. 50 deg
pivot O
pivot C
link OA
link CD
slider E along x
slot E in OA
slot E in CD
OA = 120 mm @ t
OE = 60 mm @ t
CD = 100 mm @ 100 deg
CE = 70 mm @ 100 deg
torque P on OA
torque F on CD
find k = P/F
find R_E
"""


@pytest.mark.parametrize(
    ("text", "names"),
    [(PUSHED_ON_A_GUIDE, {"N_D", "N_D_guide"}), (IN_TWO_SLOTS, {"N_E_OA", "N_E_CD", "N_E_guide"})],
)
def test_forces_of_guide_and_contacts_on_one_pin_have_names_of_their_own(text, names):
    """Of two forces with one name a sum had one term, and what followed from it was false."""
    compilation = Compilation(Source("pin.mech", text))
    listed = [{n for f in e.forces for n in f.names} for e in compilation.equilibrium]
    assert names == {n for of_one in listed for n in of_one if n[:3] in ("N_D", "N_E")}
    assert agree(compilation, 3) == 3 * len(listed)
