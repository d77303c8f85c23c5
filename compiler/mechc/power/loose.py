"""What hangs loose in a mechanism that moves more freely than was meant."""

from collections.abc import Iterable, Sequence

from ..diagnostics.syntax import listed
from ..model.mechanism import Contact, Mechanism, Rack, Screw, Slot

FEW = 3
"""Parts that a hint names."""


def looseness(mechanism: Mechanism) -> str:
    """Return what nothing joins, or hangs on one pin alone, in words; '' where nothing does."""
    apart = _apart(mechanism)
    if len(apart) > 1:
        return f"join {_named(apart[0])} to {_named(apart[1])}: nothing does"
    for link in mechanism.links:
        joints = [p for p in link.points if _joined(p, link.name, mechanism)]
        on_the_ground = any(p.point in joints for p in mechanism.pivots)
        if len(joints) < 2 and not on_the_ground and not _held_otherwise(link.name, mechanism):
            where = f"pin {joints[0]} alone" if joints else "nothing"
            return f"hold link {link.name}, which hangs on {where}"
    return ""


def _named(parts: Sequence[str]) -> str:
    return listed(parts[:FEW], "and") if len(parts) <= FEW else f"{parts[0]} and its neighbours"


def _apart(mechanism: Mechanism) -> list[list[str]]:
    """Return the groups of moving parts that no pin, slot, contact or wheel joins."""
    fixed = {p.point for p in mechanism.pivots}
    groups: list[tuple[set[str], list[str]]] = []
    for name, keys in _parts(mechanism, fixed):
        met = [group for group in groups if group[0] & keys]
        merged = set(keys).union(*(group[0] for group in met))
        names = [n for group in met for n in group[1]]
        groups = [group for group in groups if group not in met]
        groups.append((merged, [*names, name] if name else names))
    return [names for _, names in groups if names]


def _parts(mechanism: Mechanism, fixed: set[str]) -> Iterable[tuple[str, set[str]]]:
    """Yield moving parts by the points and bodies that they are one with, then what joins them."""
    carried = {p for k in mechanism.links for p in k.points}
    carried |= {p for s in mechanism.slides for p in s.points}
    touches: list[Slot | Contact] = [*mechanism.slots, *mechanism.contacts]
    drawn: list[Rack | Screw] = [*mechanism.racks, *mechanism.screws]
    for link in mechanism.links:
        yield f"link {link.name}", {*link.points, f"link {link.name}"} - fixed
    for slide in mechanism.slides:
        yield f"slide {slide.name}", set(slide.points)
    for slider in mechanism.sliders:
        yield "" if slider.point in carried else f"slider {slider.point}", {slider.point}
    for touch in touches:
        yield "", {touch.point, touch.tail, touch.head, f"link {touch.link}"} - fixed
    for mesh in mechanism.wheel_pairs:
        yield "", {f"link {mesh.first_link}", f"link {mesh.second_link}"}
    for pulled in drawn:
        yield "", {pulled.point, f"link {pulled.link}"}


def _joined(point: str, link: str, mechanism: Mechanism) -> bool:
    """Tell whether anything but a load holds a link at a point."""
    at = {p.point for p in mechanism.pivots} | {s.point for s in mechanism.sliders}
    at |= {p for s in mechanism.slides for p in s.points}
    at |= {t.point for t in mechanism.slots} | {t.point for t in mechanism.contacts}
    at |= {p for k in mechanism.links if k.name != link for p in k.points}
    shared = mechanism.mirror or mechanism.copies
    return point in at or bool(shared and point in shared.sharing)


def _held_otherwise(link: str, mechanism: Mechanism) -> bool:
    """Tell whether a slot or a face of the link itself, or a wheel, holds it."""
    touched = {t.link for t in mechanism.slots} | {t.link for t in mechanism.contacts}
    turned = {n for m in mechanism.wheel_pairs for n in (m.first_link, m.second_link)}
    return link in touched | turned
