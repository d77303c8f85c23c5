"""The parser's tables, made once and shipped: building them takes fifteen times as long.

``python -m mechc.syntax.grammar`` writes ``grammar/tables.json``. The file names the Lark
version and the grammar it was made from; where either differs the tables are built anew,
so an outdated file costs time and nothing else.
"""

import json
from hashlib import sha256
from typing import Any, cast

import lark
from lark import Lark, Token, Transformer
from lark.grammar import Rule
from lark.lexer import TerminalDef

from ..data import data

Builder = Transformer[Token, Any]


def grammar() -> str:
    """Return the text of the grammar."""
    return (data("grammar") / "mechc.lark").read_text("utf-8")


def made_from(text: str, starts: list[str]) -> dict[str, str]:
    """Return what tables depend on."""
    content = "\n".join([text, *starts])
    return {"lark": lark.__version__, "grammar": sha256(content.encode()).hexdigest()}


def parser(starts: list[str], builder: Builder) -> Lark:
    """Return the parser, from the shipped tables if they are of this grammar."""
    text = grammar()
    shipped = data("grammar") / "tables.json"
    if shipped.is_file():
        found = json.loads(shipped.read_text("utf-8"), object_hook=with_numbers)
        if found["made_from"] == made_from(text, starts):
            return loaded(found, builder)
    return built(text, starts, builder)


def built(text: str, starts: list[str], builder: Builder | None = None) -> Lark:
    """Return a parser with tables built from the grammar."""
    return Lark(text, parser="lalr", lexer="basic", start=starts, transformer=builder)


def loaded(found: dict[str, Any], builder: Builder) -> Lark:
    """Return a parser from its tables, as Lark's own stand-alone parsers are made."""
    return cast(
        Lark,
        Lark._load_from_dict(found["data"], found["memo"], transformer=builder),  # type: ignore[no-untyped-call]
    )


def with_numbers(table: dict[str, Any]) -> dict[Any, Any]:
    """Return a table with the whole numbers that JSON made texts of as keys."""
    return {int(key) if key.isdigit() else key: value for key, value in table.items()}


def written(starts: list[str]) -> str:
    """Return the tables as the text of their file."""
    text = grammar()
    tables, memo = built(text, starts).memo_serialize([TerminalDef, Rule])
    content = {"made_from": made_from(text, starts), "data": tables, "memo": memo}
    return json.dumps(content, separators=(",", ":")) + "\n"
