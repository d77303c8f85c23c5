"""What a calculation note says of its lines."""

from ...model.mechanism import Axial, Normal, Reaction, WithFriction
from ...study.analysis import Analysis
from ..languages.locale import Locale
from ..note import NoteLine
from .remarks import kind
from .speller import Speller, component_words


def label(line: NoteLine, text: str, locale: Locale, spell: Speller) -> str:
    """Return the text of a line; before that of a result of a used mechanism what it is."""
    said = _kind(line.result, locale, spell) if line.result else ""
    return f"{said[:1].lower()}{said[1:]} {text}".strip()


def _kind(result: Analysis, locale: Locale, spell: Speller) -> str:
    """Return the kind of a result in words; of a force at a joint its component, too."""
    match result.target:
        case WithFriction(Reaction() | Normal() | Axial() as force):
            said = locale.at_joints["with friction"]
            return said.format(force=component_words(force, locale, spell))
        case Reaction() | Normal() | Axial() as force:
            return component_words(force, locale, spell)
        case _:
            return kind(result, locale, spell)
