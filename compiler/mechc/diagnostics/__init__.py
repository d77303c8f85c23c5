"""Errors and warnings: their type, their words (a module per stage), their rendering."""

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
