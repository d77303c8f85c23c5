"""The parser's tables, made once and shipped: making them takes longer than a compilation.

``made_tables`` names the grammar that it was made from; where that differs the tables are
made anew, so an outdated file costs time and nothing else. It is Python, as compiled Python is
read a third as long as JSON.
"""

from importlib import import_module
from typing import Literal, cast, get_args
from zlib import crc32

from ...data import data
from .lalr import Tables

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
    made = import_module(f"{__package__}.made_tables")
    if checksum(text) == made.MADE_FROM:
        return cast(Tables, made.TABLES)
    return cast(Tables, import_module(f"{__package__}.make_tables").make(text, STARTS))
