"""Messages for expectations that do not hold (E58x, W58x)."""

from collections.abc import Mapping
from typing import Literal

from ..source import Span
from .diagnostic import Message, coded

LikelySlip = Literal["", "sign", "inverse", "twice", "unit", "degrees", "figure"]
"""What two numbers differ by, where that shows what was taken for what."""


def _pose(at: Mapping[str, str]) -> str:
    return ", ".join(f"{name} = {value}" for name, value in at.items()) or "every pose"


@coded("E581")
def expectation_refuted(
    span: Span,
    subject: str,
    found: str,
    expected: str,
    at: Mapping[str, str],
    slip: LikelySlip = "",
    load: str = "",
) -> Message:
    """An ``expect`` does not hold: a pose was found where the two numbers differ.

    ``expect`` states what a book or a colleague says of a result. It is proved equal by
    algebra, or refuted by a pose, which is printed with both numbers::

        expect k = 2*b/a*tan(alpha)                # a slip: the book has cot
        expect k = 2*b/a*cot(alpha)

    A number is compared within half a unit of the last digit written, so write as many
    digits as the source gives::

        expect k = 7.1407 at alpha = 35 deg

    Where only the sign differs, a load may be drawn the other way; where the numbers differ by a
    power of ten, a unit may be wrong; where one is twice the other, or its inverse, that is said.
    A force is expected at the value of the ``load`` that it rests on.
    """
    does = "has no value" if found.startswith("nan") else f"is {found}"
    message = f"{subject} {does} where {expected} is expected, at {_pose(at)}"
    hint = f"say at which {load} it is expected: … at {load} = …" if load else _SLIPS[slip]
    return Message(span, message, hint)


_SLIPS: Mapping[LikelySlip, str] = {
    "": "fix the expectation, or the geometry it was written for",
    "sign": "only the sign differs: look which way the loads are directed",
    "inverse": "the one is the inverse of the other: look which load stands above the line",
    "twice": "the one is twice the other: look at halves, branches, and loads that act twice",
    "unit": "the numbers differ by a power of ten: look at the units",
    "figure": "it agrees at the values given: say so by a tolerance, 0.35 +- 0.01, or by at",
    "degrees": "the numbers differ by 180/pi: degrees were taken for radians",
}


def _counted(poses: int) -> str:
    return "the one pose tried" if poses == 1 else f"all {poses} poses tried"


@coded("W581")
def expectation_unproved(span: Span, subject: str, poses: int, is_number: bool) -> Message:
    """An ``expect`` agrees at every pose tried, but algebra did not prove it.

    The two formulas may be equal only within the ranges of the parameters (a square root
    whose sign is lost outside them), or be beyond what can be decided exactly. The
    figures agree to twelve digits at each pose. A whole number is such a formula, while one with
    decimals is a figure of the default pose.
    """
    message = f"the formula for {subject} agrees at {_counted(poses)}, but is not proved equal"
    proof = "write it in the same angles as the result to have it proved"
    figure = "a figure of the default pose has decimals, as 8.0, or a tolerance, 8 +- 0.1"
    return Message(span, message, figure if is_number else proof)


@coded("E582")
def expectation_without_pose(span: Span, subject: str, missing: str) -> Message:
    """An ``expect`` of a number needs a value for every parameter.

    A number can be compared at one pose only, and a parameter of the result has neither
    a value of its own nor one after ``at``::

        param alpha: angle
        expect k = 7.1407                          # at which alpha?
        expect k = 7.1407 at alpha = 35 deg
    """
    message = f"{subject} cannot be compared with a number: {missing} has no value"
    return Message(span, message, f"add `at {missing} = …`")
