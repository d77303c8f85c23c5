"""What ``mechc show`` prints of the stages, for people."""

import json

import pytest

from mechc.cli import main
from mechc.cli.commands.show import text_of
from mechc.compilation import VIEWS, Compilation
from mechc.files import find, read
from mechc.source import Source
from sources import in_thirds


def opened(name: str) -> Compilation:
    return Compilation(read(find(name)))


def show(stage: str, name: str) -> list[str]:
    return text_of(stage, opened(name)).splitlines()


def test_the_tree_shows_what_was_written() -> None:
    lines = show("syntax", "slider_crank_claw")
    assert "    Vector(points=OC, value=Cartesian(x=x_C, y=-h))" in lines
    assert "    Expect(subject=k, value=(h + f*x_C)*cos(beta)/(l_A*sin(phi + beta)))" in lines


def test_a_mechanism_shows_quantities_joints_and_what_is_asked_for() -> None:
    lines = show("model", "slider_crank_claw")
    height = "name=h, dimension=length in m, value=3/25, unit=mm, label=contact C below the pivot"
    assert f"    Parameter({height})" in lines
    assert "    Link(name=OAC, points=(O, A, C))" in lines
    assert "  finds: (Find(name=k, target=LoadRatio(above=P, below=R)))" in lines


def test_a_pose_shows_directions_and_vectors() -> None:
    lines = show("pose", "slider_crank_claw")
    assert "  mechanism: as in model" in lines
    assert "      A: (Arm(length=l_A, angle=-phi + 90 deg))" in lines
    assert "  guides: {B: -90 deg}" in lines
    assert "  placeholders: {len_AB: none}" in lines


def test_a_plan_shows_unknowns_rules_order_and_speeds() -> None:
    lines = show("kinematics", "equalising_clamp")
    assert "    pose: as in pose" in lines
    assert "      UnknownSpeed(kind=spin, of=BAC)" in lines
    assert "        rule: projection" in lines
    assert "  drives: (0, 1)" in lines
    assert any(line.startswith("  speeds:") and "2: ((b + c)/b, -c/b)" in line for line in lines)


def test_a_balance_shows_powers_and_ties() -> None:
    lines = show("power", "slider_crank_claw")
    assert "  plan: as in kinematics" in lines
    assert "      tie: (R, f)" in lines


def test_friction_shows_what_was_solved_before() -> None:
    assert show("friction", "slider_crank_claw")[-2:] == [
        "  balance: as in power",
        "  solved: as in power.solved",
    ]
    lines = show("friction", "claw_with_friction")
    assert any(line.startswith("    SolvedWithFriction") for line in lines)


def test_a_study_shows_what_follows_from_the_results() -> None:
    lines = show("study", "slider_crank_claw")
    assert "      factor: sin(beta + phi)" in lines
    assert "      cause: DeadCentre(still=Acted(name=B), moving=Acted(name=C))" in lines


def test_a_routine_shows_its_steps_as_a_program() -> None:
    lines = show("routine", "claw_with_friction")
    assert "        t1 = sqrt((1 - p1)*(1 + p1))" in lines
    assert "      inputs: as in routine.functions.k_f.inputs" in lines


def test_a_figure_shows_points_and_parts() -> None:
    lines = show("figure", "crank_rocker")
    assert any("O2: (0.1, 0)" in line for line in lines)
    assert (
        "    Link(name=O1A, points=(O1, A), outline=(O1, A), rods=((O1, A)), label=crank)" in lines
    )


def test_where_nothing_can_be_assembled_there_is_no_figure() -> None:
    compilation = opened("crank_rocker")
    compilation.figure = None  # type: ignore[misc]
    assert text_of("figure", compilation).startswith("There is no figure")


def test_a_description_without_a_result_shows_what_it_can() -> None:
    source = Source("lever.mech", "mechanism lever\nparam a = 1 m\npivot O\nfind k = P/F\n")
    assert "    Pivot(point=O)" in text_of("syntax", Compilation(source))


@pytest.mark.parametrize(
    "name", in_thirds(["wheelbarrow", "triad_press", "peaucellier", "scissor_2"])
)
def test_no_record_of_python_is_shown(name: str) -> None:
    shown = "".join(text_of(stage, opened(name)) for stage in VIEWS)
    for sign in ("Angle(", "Product(", "Fraction(", "Span(", "None", "=<", "Number(", "object at"):
        assert sign not in shown


@pytest.mark.parametrize("stage", VIEWS)
def test_every_stage_can_be_had_as_json(stage: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["show", stage, "toggle_press", "--format", "json"]) == 0
    found = json.loads(capsys.readouterr().out)
    if stage == "model":
        assert [p["name"] for p in found["parameters"]] == ["e", "phi", "psi", "alpha", "beta"]
        assert found["parameters"][1]["range"] == {
            "kind": "Interval",
            "low": "pi/3",
            "high": "5*pi/6",
        }
    if stage == "figure":
        assert found["points"]["O"] == {"kind": "Plane", "x": 0.0, "y": 0.0}
