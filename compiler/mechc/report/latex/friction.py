"""What rubs, in sentences."""

from collections.abc import Iterator
from typing import assert_never

from ...formula.tree import Formula, Product
from ...model.mechanism import (
    FaceFriction,
    Friction,
    GuideFriction,
    JointFriction,
    LoadForm,
    LoadRatio,
    Mechanism,
    PinFriction,
    ThreadFriction,
    WheelFriction,
)
from ..languages.locale import Locale
from ..sentences.wording import enumeration
from .directions import math
from .notation import Notation, name, points
from .printer import latex
from .quantity import length_of


def rubbing_sentences(mechanism: Mechanism, locale: Locale, style: Notation) -> Iterator[str]:
    """Yield a sentence for all pins of one radius, each other joint, and the motion meant."""
    friction = mechanism.friction
    if friction.is_ideal:
        return
    if friction.efficiency is not None:
        value = math(latex(friction.efficiency, style))
        yield locale.rubbing["efficiency"].format(value=value)
    else:
        yield from _pins(friction, locale, style)
        for rub in friction.rubbing:
            yield from _joint(rub, locale, style)
    if drives := [math(name(drive, style)) for drive in _driving(mechanism)]:
        yield locale.rubbing[friction.sense].format(loads=enumeration(drives, locale))


def _driving(mechanism: Mechanism) -> list[str]:
    """Return the loads that drive, or yield, in what is asked for."""
    drives = []
    for find in mechanism.finds:
        match find.target:
            case LoadRatio(drive) | LoadForm(drive):
                drives.append(drive)
    return list(dict.fromkeys(drives))


def _pins(friction: Friction, locale: Locale, style: Notation) -> Iterator[str]:
    alike: dict[Formula, list[str]] = {}
    for rub in friction.rubbing:
        if isinstance(rub, PinFriction):
            alike.setdefault(rub.radius, []).append(math(points(rub.point)))
    for radius, named in alike.items():
        template = locale.rubbing["pins" if len(named) > 1 else "pin"]
        yield template.format(
            points=enumeration(named, locale), value=math(length_of(radius, locale, style))
        )


def _joint(rub: JointFriction, locale: Locale, style: Notation) -> Iterator[str]:
    point = math(points(rub.point))
    match rub:
        case PinFriction():
            return
        case GuideFriction(_, factor):
            kind = "reduced guide" if isinstance(factor, Product) else "guide"
            yield locale.rubbing[kind].format(point=point, value=math(latex(factor, style)))
        case FaceFriction(_, factor):
            yield locale.rubbing["face"].format(point=point, value=math(latex(factor, style)))
        case WheelFriction(_, kind, _, factor):
            yield locale.rubbing[kind].format(point=point, value=math(latex(factor, style)))
        case ThreadFriction(_, _, factor, thread):
            value, diameter = math(latex(factor, style)), math(length_of(thread, locale, style))
            yield locale.rubbing["screw"].format(point=point, value=value, diameter=diameter)
        case _:
            assert_never(rub)
