"""A drawing as PDF, by typst: a library that is installed with ``mechc[pdf]``."""

from importlib import import_module
from typing import Any

from ...diagnostics import MechcError
from ...diagnostics.plot import no_library
from ...drawing.drawing import Drawing
from ..svg.picture import to_svg

_PAGE = "#set page(width: auto, height: auto, margin: 0pt)\n"


def to_pdf(drawing: Drawing) -> bytes:
    """Return a picture on a page of its size; :class:`MechcError` (E590) without the library."""
    try:
        typst: Any = import_module("typst")
    except ImportError as error:
        raise MechcError([no_library("PDF", "pdf", str(error))]) from None
    text = to_svg(drawing).replace("\\", "\\\\").replace('"', '\\"')
    page = f'{_PAGE}#image(bytes("{text}"), format: "svg")\n'
    return bytes(typst.compile(page.encode(), format="pdf", timestamp=0))
