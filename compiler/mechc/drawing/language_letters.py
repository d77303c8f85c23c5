"""Numbers and units in the letters of a language."""

from collections.abc import Iterable

from ..base.frozen import replace
from ..formula.letters import LATIN, Letters, lettered, of_unit
from .drawing import Drawing, TextRun
from .lettering import name

Runs = tuple[TextRun, ...]


def in_letters(drawing: Drawing, letters: Letters) -> Drawing:
    """Return a drawing with its numbers and units in the letters of a language.

    A title is text of the description, and stays as it is.
    """
    if letters == LATIN:
        return drawing
    labels = (label._replace(runs=spelled(label.runs, letters)) for label in drawing.labels)
    about = drawing.description.split(drawing.title)
    description = drawing.title.join(lettered(part, letters) for part in about)
    return replace(drawing, labels=tuple(labels), description=description)


def spelled(runs: Iterable[TextRun], letters: Letters) -> tuple[TextRun, ...]:
    """Return text with its numbers and units in the letters of a language.

    >>> russian = Letters({"mm": "мм", "s": "с"}, ",")
    >>> [r.text for r in spelled([TextRun("r = 1.5\u2009mm"), TextRun("mm/s", unit=True)], russian)]
    ['r = 1,5\u2009мм', 'мм/с']
    """
    shown = tuple(runs)
    for called, there in letters.names.items():
        shown = _renamed(shown, name(called), name(there))
    return tuple(run if run.italic else run._replace(text=_spelled(run, letters)) for run in shown)


def _renamed(runs: Runs, called: Runs, there: Runs) -> Runs:
    """Return runs in which a name, or a word in names, is another.

    >>> [r.text for r in _renamed(name("P_far"), name("far"), name("дал"))]
    ['P', 'дал']
    >>> both = *name("F_C_1"), TextRun(", "), *name("F_C")
    >>> [r.text for r in _renamed(both, name("F_C"), name("F_ц"))]
    ['F', 'C', ',1', ', ', 'F', 'ц']
    """
    if len(called) == len(there) == 1:
        word = called[0].text
        return tuple(r._replace(text=there[0].text) if r.text == word else r for r in runs)
    ends = range(len(called), len(runs) + 1)
    at = next((e for e in ends if runs[e - len(called) : e] == called and _ends(runs[e:])), None)
    return runs if at is None else (*runs[: at - len(called)], *there, *runs[at:])


def _ends(runs: Runs) -> bool:
    """Return whether no more indices follow."""
    return not runs or runs[0].level == 0


def _spelled(run: TextRun, letters: Letters) -> str:
    return of_unit(run.text, letters) if run.unit else lettered(run.text, letters)
