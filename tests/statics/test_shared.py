"""The referee's work: what does not depend on the question is done once for each pose."""

import pytest

from mechc.compilation import Compilation
from mechc.source import Source
from mechc.statics import balanced
from mechc.statics.referee import CHECKED_POSES
from small_mechanisms import four_bar

FOUR_BAR = "mechanism four_bar\n" + four_bar(
    "find M", phi="60 deg in 50 deg .. 80 deg", drive="", assembly="ccw"
)

SPRINGS = "".join(
    f"pivot Q{i} at (0 mm, {i + 3} mm)\nspring 5 N/mm between Q{i} and B free 20 mm\n"
    for i in range(12)
)


@pytest.mark.parametrize("task", ["equilibrium", "eliminated"])
def test_equations_are_set_up_once_for_each_pose(task, monkeypatch):
    done = []
    real = getattr(balanced, task)
    monkeypatch.setattr(balanced, task, lambda *given: done.append(1) or real(*given))
    verdict = Compilation(Source("springs.mech", FOUR_BAR + SPRINGS)).verdict
    assert len(verdict.trials) == 13 * CHECKED_POSES
    assert len(done) == CHECKED_POSES
