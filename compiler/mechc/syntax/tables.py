"""The parser's tables, made once and shipped: making them takes longer than a compilation.

``grammar/tables.json`` names the grammar that it was made from; where that differs the
tables are made anew, so an outdated file costs time and nothing else.
"""

import json
from importlib import import_module
from typing import Any, Literal, cast, get_args
from zlib import crc32

from ..data import data
from .lalr import Rule, Tables

Start = Literal[
    "statement",
    "expression",
    "direction",
    "vector",
    "range",
    "result",
    "condition",
    "expectation",
    "reported",
    "end",
    "rim",
    "route",
    "measure",
    "let_value",
    "row",
    "unit",
]
"""What a text may be read as: a whole statement, or what one YAML scalar holds."""

STARTS = [*get_args(Start), "between"]


def grammar() -> str:
    """Return the text of the grammar."""
    return (data("grammar") / "mechc.lark").read_text("utf-8")


def checksum(text: str) -> int:
    """Return the checksum of the grammar that tables were made from."""
    return crc32("\n".join([text, *STARTS]).encode())


def tables() -> Tables:
    """Return the tables, the shipped ones if they are of this grammar."""
    text = grammar()
    shipped = data("grammar") / "tables.json"
    if shipped.is_file():
        found = json.loads(shipped.read_text("utf-8"))
        if found.pop("made_from", None) == checksum(text):
            return loaded(found)
    return cast(Tables, import_module(f"{__package__}.make_tables").make(text, STARTS))


def loaded(found: dict[str, Any]) -> Tables:
    """Return tables from their file's content."""
    return Tables(**found)._replace(rules=[Rule(*rule) for rule in found["rules"]])
