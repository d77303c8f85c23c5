"""Quantities of the mechanism itself, named by its points: ``V_D``, ``phi_AB``."""

import re
from typing import NamedTuple

from ..syntax.vocabulary import points_of

FORMS = {
    "V": "the velocity of a point",
    "omega": "the angular velocity of a link",
    "R": "the force on a pin",
    "N": "the force along a rod, or of a guide",
    "phi": "the direction of a vector",
    "len": "the length of a vector",
}
"""Quantities of the mechanism itself, as ``V_D``: their prefixes and meanings."""

_FORM = re.compile(rf"({'|'.join(FORMS)})_(.+)")
_SEVERAL_POINTS = frozenset({"omega", "phi", "len"})
_ONE_POINT = frozenset({"V", "R"})


class Form(NamedTuple):
    """A reserved name taken apart: ``omega_OB`` is ``omega`` of O and B."""

    prefix: str
    points: tuple[str, ...]


def form_of(name: str) -> Form | None:
    """Take a reserved name apart; None for any other name.

    >>> form_of("omega_OB"), form_of("R_o"), form_of("phi_A")
    (Form(prefix='omega', points=('O', 'B')), None, None)
    """
    match = _FORM.fullmatch(name)
    points = points_of(match[2]) if match else ()
    if not match or not points:
        return None
    misfits = _ONE_POINT if len(points) > 1 else _SEVERAL_POINTS
    return None if match[1] in misfits else Form(match[1], points)
