"""A compilation ends: what goes on without end is stopped by count, with a message of its own."""

from threading import Thread

import pytest

from good_mechanisms import ALL
from mechc import stage, work
from mechc.algebra import multiples
from mechc.algebra.product import Product
from mechc.cli import main
from mechc.diagnostics import MechcError
from mechc.driver import Compilation, complete
from mechc.source import Source
from mechc.work import LIMIT, Allowance, WorkLimitError, at_most, spend

ROD = """
slider A along x
slider C along 45 deg
link AC
AC = 100 mm @ 70 deg
force P at A along x
force F at C along 225 deg
find k = P/F
"""


def test_work_is_counted_inside_of_the_allowance_only():
    spend(10**12)
    with at_most(Allowance(10)):
        spend(10)
        with pytest.raises(WorkLimitError):
            spend(1)
    spend(10**12)


def test_threads_count_for_themselves():
    found = []

    def other():
        spend(10**12)
        found.append("ended")

    with at_most(Allowance(1)):
        thread = Thread(target=other)
        thread.start()
        thread.join()
    assert found == ["ended"]


@pytest.fixture
def runaway(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let every product have one more sine that could be cancelled, for ever."""
    monkeypatch.setattr(multiples, "_one_part_less", lambda product: product * Product(1))


@pytest.mark.usefixtures("runaway")
def test_a_runaway_ends_with_a_message_and_status_4(tmp_path, capsys):
    file = tmp_path / "rod.mech"
    file.write_text(ROD)
    assert main(["check", str(file)]) == 4
    error = capsys.readouterr().err
    assert "error[E817]" in error
    assert f"algebra took more than {LIMIT} steps" in error


@pytest.mark.usefixtures("runaway")
def test_all_that_was_found_before_is_reported_too():
    compilation = Compilation(Source("rod.mech", ROD))
    compilation.allowance = Allowance(1000)
    with pytest.raises(MechcError) as error:
        complete(compilation)
    assert [d.code for d in error.value.diagnostics] == ["E817"]
    assert error.value.source is compilation.source


@pytest.mark.parametrize("name", ["double_butterfly", "jansen_leg", "class_four_block"])
def test_the_longest_formulas_take_less_than_a_tenth_and_always_the_same(name):
    taken = []
    for _ in range(2):
        compilation = Compilation(Source(name, ALL[name].read_text(encoding="utf-8")))
        complete(compilation)
        taken.append(LIMIT - compilation.allowance.left)
    assert taken[0] == taken[1]
    assert 0 < taken[0] < LIMIT / 10


def test_nothing_is_left_over_from_a_compilation():
    with pytest.raises(MechcError), stage.within(Allowance(0), Compilation(Source("a", "")).report):
        spend(1)
    assert work._ALLOWANCE.get() is None
