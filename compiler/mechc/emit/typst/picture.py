"""A drawing as PDF or PNG, by typst: a library that is installed with ``mechc[pdf]``.

It has letters of its own, Cyrillic and Greek among them, and is asked for no others: a
picture is the same on a machine without fonts.
"""

from importlib import import_module
from typing import Any

from ...diagnostics import MechcError
from ...diagnostics.drawing import no_library
from ...drawing.drawing import Drawing
from ..svg.picture import to_svg

DENSITY = 150
"""Points to an inch of a PNG."""

_PAGE = "#set page(width: auto, height: auto, margin: 0pt)\n"


def to_pdf(drawing: Drawing) -> bytes:
    """Return a picture on a page of its size; :class:`MechcError` (E721) without the library."""
    return _set(drawing, "PDF", format="pdf", timestamp=0)


def to_png(drawing: Drawing) -> bytes:
    """Return a picture in points; :class:`MechcError` (E721) without the library."""
    return _set(drawing, "PNG", format="png", ppi=DENSITY)


def _set(drawing: Drawing, what: str, **options: Any) -> bytes:
    try:
        typst: Any = import_module("typst")
    except ImportError as error:
        raise MechcError([no_library(what, what.lower(), str(error))]) from None
    text = to_svg(drawing).replace("\\", "\\\\").replace('"', '\\"')
    page = f'{_PAGE}#image(bytes("{text}"), format: "svg")\n'
    return bytes(typst.compile(page.encode(), ignore_system_fonts=True, **options))
