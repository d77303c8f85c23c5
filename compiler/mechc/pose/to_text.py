"""The pose as text, for ``mechc show pose``: directions and vectors as they were settled."""

from collections.abc import Iterator, Mapping

from ..algebra.angle import Angle
from ..formula.to_text import text
from .pose import Pose, Vector


def describe(pose: Pose) -> str:
    """Return every direction and vector, lengths in SI, directions in degrees from +x."""
    return "\n".join(_lines(pose)) + "\n"


def _lines(pose: Pose) -> Iterator[str]:
    yield f"free: {', '.join(pose.free) or 'nothing'}"
    yield from (f"{d.name} = {text(d.formula)}" for d in pose.definitions)
    for name, value in pose.placeholders.items():
        found = f", {text(value.formula())} in a closed loop" if value is not None else ""
        yield f"{name}: a length that is not given{found}"
    for link, frame in pose.frames.items():
        yield from _frame(link, frame)
    yield from (f"guide of {point} along {angle_text(a)}" for point, a in pose.guides.items())
    yield from (f"force {load} along {angle_text(a)}" for load, a in pose.lines.items())
    if pose.axis is not None:
        yield f"mirror line along {angle_text(pose.axis)}"


def _frame(link: str, frame: Mapping[str, Vector]) -> Iterator[str]:
    origin = next(iter(frame), "")
    yield f"link {link}, from {origin}"
    for point, vector in frame.items():
        if point != origin:
            yield f"  {origin}{point} = {vector_text(vector)}"


def vector_text(vector: Vector) -> str:
    """Return a vector in the notation of the language.

    >>> from ..algebra.product import ONE
    >>> from .pose import Arm
    >>> vector_text((Arm(ONE, Angle.of("alpha") - Angle.constant(90)),))
    '1 @ alpha - 90 deg'
    """
    terms = [f"{text(length.formula())} @ {angle_text(angle)}" for length, angle in vector]
    if len(terms) < 2:
        return terms[0] if terms else "0"
    return " + ".join(f"({term})" for term in terms)


def angle_text(angle: Angle) -> str:
    """Return a direction in degrees, as one would write it down.

    >>> angle_text(Angle.of("beta") * 2 + Angle.constant(270)), angle_text(Angle.constant(180))
    ('2*beta - 90 deg', '180 deg')
    """
    turned = (angle.degrees + 180) % 360 - 180
    degrees = 180 if turned == -180 else turned
    symbols = Angle(angle.terms)
    if not angle.terms:
        return f"{degrees} deg"
    if not degrees:
        return text(symbols.formula())
    return f"{text(symbols.formula())} {'-' if degrees < 0 else '+'} {abs(degrees)} deg"
