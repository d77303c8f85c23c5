"""A drawing as PNG, by resvg: a library that is installed with ``mechc[png]``."""

from importlib import import_module
from typing import Any

from ...diagnostics import MechcError
from ...diagnostics.drawing import no_png
from ...drawing.drawing import Drawing
from ..svg.picture import to_svg

DENSITY = 150
"""Points to an inch."""


def to_png(drawing: Drawing) -> bytes:
    """Return a picture in points; :class:`MechcError` (E721) where the library is missing."""
    try:
        resvg: Any = import_module("resvg_py")
    except ImportError as error:
        raise MechcError([no_png(str(error))]) from None
    return bytes(resvg.svg_to_bytes(svg_string=to_svg(drawing), dpi=DENSITY))
