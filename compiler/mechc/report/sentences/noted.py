"""What a calculation note says of its lines."""

from ..languages.locale import Locale
from ..note import NoteLine
from .remarks import kind
from .speller import Speller


def label(line: NoteLine, text: str, locale: Locale, spell: Speller) -> str:
    """Return the text of a line; before that of a result of a used mechanism what it is."""
    said = kind(line.result, locale, spell) if line.result else ""
    return f"{said[:1].lower()}{said[1:]} {text}".strip()
