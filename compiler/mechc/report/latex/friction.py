"""The given friction, in sentences."""

from collections.abc import Iterator
from typing import assert_never

from ...formula.tree import Formula, Product
from ...model.mechanism import (
    CollarFriction,
    FaceFriction,
    Friction,
    GuideFriction,
    JointFriction,
    LoadForm,
    LoadRatio,
    Mechanism,
    PinFriction,
    PivotFriction,
    RopeFriction,
    ThreadFriction,
    WheelFriction,
)
from ..languages.locale import Locale
from ..sentences.order import enumeration
from ..sentences.speller import LoadWords
from .notation import LatexNotation, name, points
from .printer import latex
from .quantity import length_of, math


def friction_sentences(mechanism: Mechanism, locale: Locale, style: LatexNotation) -> Iterator[str]:
    """Yield a sentence for all pins of one radius, each other joint, and the motion meant."""
    friction = mechanism.friction
    if friction.is_ideal:
        return
    if friction.efficiency is not None:
        value = math(latex(friction.efficiency, style))
        yield locale.given_friction["efficiency"].format(value=value)
    else:
        yield from _pins(friction, locale, style)
        for joint in friction.joints:
            yield from _joint(joint, locale, style)
    if driving := _driving(mechanism):
        drives = enumeration((math(name(drive, style)) for drive in driving), locale)
        of_loads = LoadWords(driving, style.couples)
        yield locale.given_friction[friction.sense].format(loads=drives, of_loads=of_loads)


def _driving(mechanism: Mechanism) -> list[str]:
    """Return the loads that drive, or yield, in what is asked for."""
    drives = []
    for find in mechanism.finds:
        match find.target:
            case LoadRatio(drive) | LoadForm(drive):
                drives.append(drive)
    return list(dict.fromkeys(drives))


def _pins(friction: Friction, locale: Locale, style: LatexNotation) -> Iterator[str]:
    alike: dict[Formula, list[str]] = {}
    for joint in friction.joints:
        if isinstance(joint, PinFriction):
            alike.setdefault(joint.radius, []).append(math(points(joint.point)))
    for radius, named in alike.items():
        template = locale.given_friction["pins" if len(named) > 1 else "pin"]
        yield template.format(
            points=enumeration(named, locale), value=math(length_of(radius, locale, style))
        )


def _joint(joint: JointFriction, locale: Locale, style: LatexNotation) -> Iterator[str]:
    """Yield the sentence of one joint's friction; that of pins stands elsewhere."""
    point = math(points(joint.point))
    match joint:
        case PinFriction():
            return
        case GuideFriction(_, factor):
            kind = "reduced guide" if isinstance(factor, Product) else "guide"
            yield locale.given_friction[kind].format(point=point, value=math(latex(factor, style)))
        case FaceFriction(_, factor):
            yield locale.given_friction["face"].format(
                point=point, value=math(latex(factor, style))
            )
        case WheelFriction(_, kind, _, factor):
            yield locale.given_friction[kind].format(point=point, value=math(latex(factor, style)))
        case ThreadFriction(_, _, factor, thread):
            value, diameter = math(latex(factor, style)), math(length_of(thread, locale, style))
            yield locale.given_friction["screw"].format(point=point, value=value, diameter=diameter)
        case CollarFriction(_, _, factor, radius):
            value, at = math(latex(factor, style)), math(length_of(radius, locale, style))
            yield locale.given_friction["collar"].format(point=point, value=value, radius=at)
        case PivotFriction(_, _, factor, radius, thrust):
            value, at = math(latex(factor, style)), math(length_of(radius, locale, style))
            yield locale.given_friction["pivot collar"].format(
                point=point, value=value, radius=at, thrust=math(latex(thrust, style))
            )
        case RopeFriction(_, _, _, coefficient, wrap):
            value, angle = math(latex(coefficient, style)), math(latex(wrap, style))
            yield locale.given_friction["rope"].format(point=point, value=value, wrap=angle)
        case _:
            assert_never(joint)
