"""The verdict as text, for ``mechc check --verbose``."""

from collections.abc import Sequence

from ...statics.verdict import Trial, Verdict

HEAD = ("result", "pose", "virtual power", "equilibrium", "error", "condition")


def to_text(verdict: Verdict) -> str:
    """Return a table of all trials, each result's default pose first, then the remarks.

    >>> trial = Trial("k", {"alpha": 0.5}, 2.0, 2.0, 0.0, 3.1)
    >>> print(to_text(Verdict((trial,))))
    result  pose  virtual power  equilibrium  error  condition
    k       1     2              2            0      3.1
    The two methods agree: worst relative error 0 in 1 trial.
    """
    lines = _table([HEAD, *_rows(verdict.trials)]) if verdict.trials else []
    return "\n".join([*lines, *verdict.remarks, _summary(verdict)])


def _rows(trials: Sequence[Trial]) -> list[tuple[str, ...]]:
    rows: list[tuple[str, ...]] = []
    seen: dict[str, int] = {}
    for trial in trials:
        seen[trial.result] = number = seen.get(trial.result, 0) + 1
        both = f"{trial.power:.12g}", f"{trial.statics:.12g}"
        rows.append((trial.result, str(number), *both, *_figures(trial)))
    return rows


def _figures(trial: Trial) -> tuple[str, str]:
    verdict = "" if trial.agrees else "  disagrees"
    return f"{trial.error:.2g}", f"{trial.condition:.2g}{verdict}"


def _table(rows: Sequence[tuple[str, ...]]) -> list[str]:
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    return [
        "  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip()
        for row in rows
    ]


def _summary(verdict: Verdict) -> str:
    number = len(verdict.trials)
    if not number:
        return "Nothing was tried."
    opinion = "agree" if verdict.agrees else "disagree"
    trials = f"{number} trial{'s' if number > 1 else ''}"
    return f"The two methods {opinion}: worst relative error {verdict.worst:.2g} in {trials}."
