"""Quantities of the mechanism itself, named by its points: ``V_D``, ``phi_AB``."""

from collections.abc import Mapping
from typing import Literal

from ...base.later import pattern
from ...base.named import NamedTuple
from ...syntax.vocabulary import points_of

FORMS = {
    "V": "the velocity of a point",
    "omega": "the angular velocity of a link",
    "R": "the force on a pin",
    "N": "the force along a rod, or of a guide",
    "phi": "the direction of a vector",
    "len": "the length of a vector",
}
"""Quantities of the mechanism itself, as ``V_D``: their prefixes and meanings."""

COORDINATES = {"x": "the place of a point along x", "y": "the place of a point along y"}
"""Quantities of a point, as ``x_B``; such a name may be a user's own as well."""

_COORDINATE = pattern(r"([xy])_([^_]+)")
_FORM = pattern(rf"({'|'.join(FORMS)})_([^_]+)(?:_([xy]))?")
AXES: Mapping[str | None, Literal["", "x", "y"]] = {None: "", "x": "x", "y": "y"}
_SEVERAL_POINTS = frozenset({"omega", "phi", "len"})
_ONE_POINT = frozenset({"V", "R"})


class ReservedName(NamedTuple):
    """A reserved name taken apart: ``omega_OB`` is ``omega`` of O and B, ``V_D_x`` has an axis."""

    prefix: str
    points: tuple[str, ...]
    axis: Literal["", "x", "y"] = ""


def form_of(name: str) -> ReservedName | None:
    """Take a reserved name apart; None for any other name.

    >>> form_of("omega_OB"), form_of("R_o"), form_of("phi_A")
    (ReservedName(prefix='omega', points=('O', 'B'), axis=''), None, None)
    >>> form_of("V_D_x"), form_of("omega_OB_x")
    (ReservedName(prefix='V', points=('D',), axis='x'), None)
    """
    match = _FORM.fullmatch(name)
    points = points_of(match[2]) if match else ()
    if not match or not points or (match[3] and match[1] != "V"):
        return None
    misfits = _ONE_POINT if len(points) > 1 else _SEVERAL_POINTS
    return None if match[1] in misfits else ReservedName(match[1], points, AXES[match[3]])


def form_of_pose(name: str) -> ReservedName | None:
    """Take a name apart that stands for something of the pose, ``x_B`` too where none has it.

    >>> form_of_pose("y_B"), form_of_pose("y_AB")
    (ReservedName(prefix='y', points=('B',), axis=''), None)
    >>> form_of_pose("phi_AB")
    ReservedName(prefix='phi', points=('A', 'B'), axis='')
    """
    if match := _COORDINATE.fullmatch(name):
        points = points_of(match[2])
        return ReservedName(match[1], points) if len(points) == 1 else None
    return form_of(name)
