"""A compilation ends: what goes on without end is stopped by count, with a message of its own."""

from threading import Thread

import pytest

from friction_chains import COUPLED
from good_mechanisms import ALL
from mechc import stage, work
from mechc.algebra import multiples
from mechc.algebra.product import Product
from mechc.cli import main
from mechc.compilation import Compilation, complete, emit
from mechc.diagnostics import MechcError
from mechc.emit import registry
from mechc.emit.target import Options
from mechc.formula.evaluate import evaluate, solution, straight_line
from mechc.formula.tree import Symbol, System, negative, number, power, product, total
from mechc.source import Source
from mechc.study import from_solution
from mechc.work import MOST_WORK, Allowance, WorkLimitError, at_most, spend, within_part
from small_mechanisms import slider_crank
from sources import in_thirds

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
    assert f"algebra and evaluation took more than {MOST_WORK} steps" in error


@pytest.mark.usefixtures("runaway")
def test_all_that_was_found_before_is_reported_too():
    compilation = Compilation(Source("rod.mech", ROD))
    compilation.allowance = Allowance(1000)
    with pytest.raises(MechcError) as error:
        complete(compilation)
    assert [d.code for d in error.value.diagnostics] == ["E817"]
    assert error.value.source is compilation.source


X, Y = Symbol("x"), Symbol("y")
CIRCLE = System(("x",), (total([power(X, number(2)), negative(Y)]),), (("y", 1.0),), (1.0,))


def test_the_way_to_a_solution_is_counted_whenever_it_is_asked_for():
    taken = []
    for _ in range(2):
        with at_most(Allowance()) as allowance:
            assert solution(CIRCLE, (4.0,)) == pytest.approx((2.0,))
        taken.append(MOST_WORK - allowance.left)
    assert taken[0] == taken[1] > 5


def test_evaluation_is_counted():
    long = total(product([(X, i)]) for i in range(2, 802))
    code = straight_line([long], ["x"])
    for evaluation in (lambda: evaluate(long, {"x": 0.5}), lambda: code.at([0.5])):
        with pytest.raises(WorkLimitError), at_most(Allowance(50)):
            evaluation()


def test_what_is_made_for_what_is_emitted_is_counted(monkeypatch):
    """A form for elsewhere is made when the document asks for it."""
    text = ROD.replace("find", "friction pins 0.1 diameter 20 mm\nfind")
    compilation = Compilation(Source("rod.mech", text))
    monkeypatch.setattr("mechc.compilation.Allowance", lambda: Allowance(20))
    with pytest.raises(MechcError) as error:
        emit(compilation, registry.load("json"), Options("rod"))
    assert [d.code for d in error.value.diagnostics] == ["E817"]


def test_a_stroke_may_take_the_more_work_the_more_rows_are_asked_for(monkeypatch):
    monkeypatch.setattr("mechc.compilation.MOST_WORK", 0)
    monkeypatch.setattr("mechc.compilation.OF_A_ROW", 100)
    made = complete(Compilation(Source("rod.mech", slider_crank("find k = M/F"))))
    with pytest.raises(MechcError) as caught:
        made.stroke(2)
    assert [d.code for d in caught.value.diagnostics] == ["E817"]
    assert len(made.stroke(200).rows) == 200


def test_a_study_of_ranges_ends_with_the_message():
    compilation = Compilation(Source("coupled.mech", COUPLED))
    _ = compilation.balance
    compilation.allowance.left = 1000
    with pytest.raises(MechcError) as error:
        _ = compilation.results
    assert [d.code for d in error.value.diagnostics] == ["E817"]


def test_what_takes_too_much_work_along_ranges_is_named_and_the_rest_is_given(monkeypatch):
    monkeypatch.setattr(from_solution, "most_of_what_is_left", lambda: Allowance(1000))
    compilation = Compilation(Source("coupled.mech", COUPLED))
    names = [r.name for r in compilation.results]
    assert names == ["k", "k_f", "k_f1", "k_hold", "eta_k"]
    found = [d for d in compilation.report.diagnostics if d.code == "W261"]
    assert [d.message.split()[0] for d in found] == ["k_f", "k_hold", "eta_k"]
    assert all(r.locking is None and not r.efficiency_ranges for r in compilation.results)
    assert compilation.verdict.trials


def test_a_part_of_the_allowance_is_taken_from_the_whole():
    with at_most(Allowance(100)) as whole:
        with within_part(Allowance(10)):
            spend(7)
        with pytest.raises(WorkLimitError), within_part(Allowance(10)):
            spend(20)
    assert whole.left == 83


LONG = ["double_butterfly", "jansen_leg", "class_four_block", "karpenko_fig4_with_friction"]


@pytest.mark.parametrize("name", in_thirds(LONG))
def test_the_longest_formulas_take_less_than_a_tenth_and_always_the_same(name):
    taken = []
    for _ in range(2):
        compilation = Compilation(Source(name, ALL[name].read_text(encoding="utf-8")))
        complete(compilation)
        taken.append(MOST_WORK - compilation.allowance.left)
    assert taken[0] == taken[1]
    assert 0 < taken[0] < MOST_WORK / 10


def test_nothing_is_left_over_from_a_compilation():
    with pytest.raises(MechcError), stage.within(Allowance(0), Compilation(Source("a", "")).report):
        spend(1)
    assert work._ALLOWANCE.get() is None
