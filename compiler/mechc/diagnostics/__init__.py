"""Errors and warnings: their type, their words (a module per stage), their rendering.

The modules of words are imported when the first of their words is needed.
"""

from typing import TYPE_CHECKING

from .diagnostic import (
    CATALOGUE,
    Diagnostic,
    MechcError,
    Message,
    Related,
    Report,
    Severity,
    coded,
    near_miss,
)

__all__ = [
    "CATALOGUE",
    "Diagnostic",
    "MechcError",
    "Message",
    "Related",
    "Report",
    "Severity",
    "coded",
    "near_miss",
]

if not TYPE_CHECKING:
    from ..base.later import waiting

    WORDS = {
        *("assembly_lines", "drawing", "drawn_places", "emission", "equilibrium", "expectations"),
        *("files", "friction", "joining", "kinematics", "open_loops", "plot", "pose"),
        *("power", "reactions", "sheets", "statics", "stroke", "syntax", "syntax_limits"),
        *("syntax_yaml", "uses"),
    }
    __getattr__ = waiting(__name__, WORDS | {"render"})
