"""What a calculation note says of its lines."""

from ...model.mechanism import Axial, Normal, Reaction, WithFriction
from ...study.analysis import Analysis
from ..languages.locale import Locale
from ..note import NoteLine
from .remarks import carrier, kind
from .speller import Speller


def label(line: NoteLine, text: str, locale: Locale, spell: Speller) -> str:
    """Return the text of a line; before that of a result of a used mechanism what it is."""
    said = _kind(line.result, locale, spell) if line.result else ""
    return f"{said[:1].lower()}{said[1:]} {text}".strip()


def _kind(result: Analysis, locale: Locale, spell: Speller) -> str:
    """Return the kind of a result in words; of a force its joint and component, too."""
    match result.target:
        case WithFriction(Reaction() | Normal() | Axial() as force):
            said = locale.at_joints["with friction"]
            return said.format(force=_at_joint(force, locale, spell))
        case Reaction() | Normal() | Axial() as force:
            return _at_joint(force, locale, spell)
        case _:
            return kind(result, locale, spell)


def _at_joint(force: Reaction | Normal | Axial, locale: Locale, spell: Speller) -> str:
    words = locale.at_joints
    match force:
        case Axial(_, tail, head):
            return words[carrier(force)].format(line=spell.point(f"{tail}{head}"))
        case Normal(point):
            return words["normal"].format(point=spell.point(point))
        case Reaction(point, link, part):
            where = words["on" if link else "joint"]
            said = where.format(point=spell.point(point), link=spell.point(link) if link else "")
            return words[part].format(force=said)
