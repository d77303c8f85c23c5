"""The table of a check, by hand: its columns, and what is said where the methods differ."""

from mechc.report.languages.en.checked import WORDS
from mechc.report.text.verdict import trials
from mechc.statics.verdict import Trial, Verdict


def test_a_row_has_the_error_and_then_the_condition() -> None:
    agreed = Trial("k", {}, 2.0, 2.0 + 3e-13, 1.5e-13, 31.46)
    again = Trial("k", {}, -0.125, -0.125, 0.0, 8.0)
    head, first, second = (line.split() for line in trials(Verdict((agreed, again)), WORDS))
    assert head == ["result", "pose", "virtual", "power", "equilibrium", "error", "condition"]
    assert first == ["k", "1", "2", "2", "1.5*10^-13", "31"]
    assert second == ["k", "2", "-0.125", "-0.125", "0", "8"]


def test_a_trial_that_differs_says_so() -> None:
    (_, row) = trials(Verdict((Trial("k", {}, 2.0, 3.0, 0.4, 31.46),)), WORDS)
    assert row.split()[4:6] == ["0.4", "31"]
    assert row.endswith(WORDS["differs"])
