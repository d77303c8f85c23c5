"""What ``mechc show`` prints of the stages, for people."""

import pytest

from mechc.driver import Compilation, compile_source
from mechc.files import find, read
from mechc.kinematics import to_text as kinematics
from mechc.pose import to_text as pose
from mechc.power import to_text as power


def compiled(name: str) -> Compilation:
    return compile_source(read(find(name)))


def test_a_pose_shows_directions_and_vectors() -> None:
    lines = pose.describe(compiled("slider_crank_claw").pose).splitlines()
    assert "  OA = l_A @ -phi + 90 deg" in lines
    assert "  OC = (x_C @ 0 deg) + (h @ -90 deg)" in lines
    assert "guide of B along -90 deg" in lines
    assert "len_AB: a length that is not given" in lines


def test_a_plan_shows_unknowns_rules_order_and_speeds() -> None:
    shown = kinematics.describe(compiled("equalising_clamp").plan)
    for line in (
        "mobility 2: u0, u1 taken as given",
        "  u3: angular velocity of the link BAC, counter-clockwise",
        "  B: (u0 @ -90 deg) + (b*u3 @ phi - 90 deg)",
        "  u3 from 0",
        "  u2 = (b + c)*u0/b - c*u1/b",
    ):
        assert line in shown.splitlines()
    assert "(projection, BD: B, D; on -90 deg)" in shown


def test_a_balance_shows_powers_ties_and_what_follows() -> None:
    claw = compiled("slider_crank_claw")
    lines = power.describe(claw.balance, claw.results).splitlines()
    assert "  P: P*u1" in lines
    assert "    T = f*R" in lines
    assert any(line.startswith("  infinite where sin(beta + phi) = 0") for line in lines)


@pytest.mark.parametrize("name", ["wheelbarrow", "triad_press", "peaucellier", "scissor_2"])
def test_no_record_of_python_is_shown(name: str) -> None:
    it = compiled(name)
    shown = pose.describe(it.pose) + kinematics.describe(it.plan)
    shown += power.describe(it.balance, it.results)
    assert not any(sign in shown for sign in ("Angle(", "Product(", "None", "=<", "'"))
