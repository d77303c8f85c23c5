"""What rubs, in sentences."""

from collections.abc import Iterator
from typing import assert_never

from ...formula.tree import Formula, Product
from ...model.mechanism import (
    Friction,
    LoadForm,
    LoadRatio,
    Mechanism,
    Rubbing,
    RubbingFace,
    RubbingGuide,
    RubbingMesh,
    RubbingPin,
    RubbingThread,
)
from ..languages.locale import Words
from ..sentences.wording import enumeration
from .directions import math
from .notation import Notation, name, points
from .printer import latex
from .quantity import length_of


def rubbing_sentences(mechanism: Mechanism, words: Words, style: Notation) -> Iterator[str]:
    """Yield a sentence for all pins of one radius, each other joint, and the motion meant."""
    friction = mechanism.friction
    if friction.is_ideal:
        return
    if friction.efficiency is not None:
        value = math(latex(friction.efficiency, style))
        yield words.rubbing["efficiency"].format(value=value)
    else:
        yield from _pins(friction, words, style)
        for rub in friction.rubbing:
            yield from _joint(rub, words, style)
    if drives := [math(name(drive, style)) for drive in _driving(mechanism)]:
        yield words.rubbing[friction.sense].format(loads=enumeration(drives, words))


def _driving(mechanism: Mechanism) -> list[str]:
    """Return the loads that drive, or yield, in what is asked for."""
    drives = []
    for find in mechanism.finds:
        match find.target:
            case LoadRatio(drive) | LoadForm(drive):
                drives.append(drive)
    return list(dict.fromkeys(drives))


def _pins(friction: Friction, words: Words, style: Notation) -> Iterator[str]:
    alike: dict[Formula, list[str]] = {}
    for rub in friction.rubbing:
        if isinstance(rub, RubbingPin):
            alike.setdefault(rub.radius, []).append(math(points(rub.point)))
    for radius, named in alike.items():
        template = words.rubbing["pins" if len(named) > 1 else "pin"]
        yield template.format(
            points=enumeration(named, words), value=math(length_of(radius, words, style))
        )


def _joint(rub: Rubbing, words: Words, style: Notation) -> Iterator[str]:
    point = math(points(rub.point))
    match rub:
        case RubbingPin():
            return
        case RubbingGuide(_, factor):
            kind = "reduced guide" if isinstance(factor, Product) else "guide"
            yield words.rubbing[kind].format(point=point, value=math(latex(factor, style)))
        case RubbingFace(_, factor):
            yield words.rubbing["face"].format(point=point, value=math(latex(factor, style)))
        case RubbingMesh(kind, _, factor):
            yield words.rubbing[kind].format(point=point, value=math(latex(factor, style)))
        case RubbingThread(_, factor, thread):
            value, diameter = math(latex(factor, style)), math(length_of(thread, words, style))
            yield words.rubbing["screw"].format(point=point, value=value, diameter=diameter)
        case _:
            assert_never(rub)
