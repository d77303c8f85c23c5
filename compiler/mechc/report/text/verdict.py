"""The verdict as text, for ``mechc check --verbose``."""

from collections.abc import Iterator, Sequence

from ...statics.verdict import Trial, Untried, Verdict
from ..languages.en.checked import WORDS as EN
from ..languages.locale import Words
from .character_sets import ASCII, tens

HEAD = ("result", "pose", "power", "statics", "error", "condition")


def to_text(verdict: Verdict, words: Words = EN) -> str:
    """Return the table of all trials, and what is said of them."""
    return "\n".join((*trials(verdict, words), *said(verdict, words)))


def trials(verdict: Verdict, words: Words) -> list[str]:
    r"""Return a table of all trials, each result's default pose first; none where there are none.

    >>> trial = Trial("k", {"alpha": 0.5}, 2.0, 2.0, 0.0, 3.1)
    >>> print(*trials(Verdict((trial,)), EN), sep="\n")
    result  pose  virtual power  equilibrium  error  condition
    k       1     2              2            0      3.1
    """
    head = tuple(words[each] for each in HEAD)
    return _table([head, *_rows(verdict.trials, words)]) if verdict.trials else []


def said(verdict: Verdict, words: Words) -> Iterator[str]:
    """Yield the sentences below the table.

    >>> print(*said(Verdict((Trial("k", {}, 2.0, 2.0, 0.0, 3.1),)), EN))
    The two methods agree: worst relative error 0 in 1 trial.
    """
    yield from untried(verdict.remarks, words)
    yield _summary(verdict, words)


def agreement(verdict: Verdict, words: Words) -> str:
    """Return in how many trials the equilibrium of the free bodies agrees.

    >>> agreement(Verdict((Trial("k", {}, 2.0, 2.0, 0.0, 3.1),)), EN)
    'equilibrium of the free bodies agrees in 1 trial'
    """
    number = len(verdict.trials)
    return words["equilibrium"].format(count=number, trials=_counted(number, words))


def untried(remarks: Sequence[Untried], words: Words) -> Iterator[str]:
    """Yield a line on each result that was checked at fewer poses than are wanted, and why."""
    for result, count, poses, reason in remarks:
        yield words["judged"].format(name=result, count=count, poses=poses, reason=words[reason])


def _rows(trials: Sequence[Trial], words: Words) -> list[tuple[str, ...]]:
    rows: list[tuple[str, ...]] = []
    seen: dict[str, int] = {}
    for trial in trials:
        seen[trial.result] = number = seen.get(trial.result, 0) + 1
        both = _figures(trial.power, 12), _figures(trial.statics, 12)
        rows.append((trial.result, str(number), *both, *_errors(trial, words)))
    return rows


def _errors(trial: Trial, words: Words) -> tuple[str, str]:
    verdict = "" if trial.agrees else f"  {words['differs']}"
    return _figures(trial.error, 2), f"{_figures(trial.condition, 2)}{verdict}"


def _figures(value: float, digits: int) -> str:
    """Return a number to so many digits, as a description has it but for powers of ten."""
    return tens(f"{value:.{digits}g}", ASCII)


def _table(rows: Sequence[tuple[str, ...]]) -> list[str]:
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    return [
        "  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip()
        for row in rows
    ]


def _summary(verdict: Verdict, words: Words) -> str:
    number = len(verdict.trials)
    if not number:
        return words["nothing"]
    opinion = words["agree" if verdict.agrees else "disagree"]
    return opinion.format(
        error=_figures(verdict.worst, 2), count=number, trials=_counted(number, words)
    )


def _counted(number: int, words: Words) -> str:
    return words["trial" if number == 1 else "trials"]
