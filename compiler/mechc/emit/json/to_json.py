"""JSON: the whole result for other programs, described by ``grammar/result.schema.json``."""

import json
from collections.abc import Callable
from functools import partial

from ...formula.tree import Formula
from ...report.latex.document_style import style_of
from ...report.latex.notation import LatexNotation, notation
from ...report.latex.printer import latex
from ..target import Compiled, Emitted, Options
from .document import DOCUMENT
from .kinds import Json


class JsonTarget:
    """``--emit json``."""

    name = "json"
    suffixes = (".json",)

    def emit(self, compiled: Compiled, options: Options) -> tuple[Emitted, ...]:
        """Return the document; NaN and infinities are null."""
        document = DOCUMENT.write(compiled)
        assert isinstance(document, dict)
        used = document["used_mechanisms"]
        assert isinstance(used, list)
        parts = (part for _, part in compiled.used_mechanisms)
        document["used_mechanisms"] = [
            _typeset(one, _style(part)) for one, part in zip(used, parts, strict=True)
        ]
        text = _text(document, partial(latex, style=_style(compiled)))
        return (Emitted(f"{options.stem}.json", text),)


TARGET = JsonTarget()


def schema_text() -> str:
    """Return the JSON Schema of the document, made from the same records as the document."""
    schema: Json = {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "Result of mechc",
        **DOCUMENT.schema,
        "$defs": dict(DOCUMENT.definitions),
    }
    return _text(schema)


def _style(compiled: Compiled) -> LatexNotation:
    return style_of(compiled.mechanism, compiled.derivation.results, notation("en"))


def _typeset(value: Json, style: LatexNotation) -> Json:
    """Return a value with LaTeX for its formulas: a used mechanism has angles of its own."""
    match value:
        case dict():
            return {name: _typeset(inner, style) for name, inner in value.items()}
        case list():
            return [_typeset(inner, style) for inner in value]
        case None | bool() | int() | float() | str():
            return value
        case _:
            return latex(value, style)


def _text(document: Json, written: Callable[[Formula], str] | None = None) -> str:
    """Return a document as text; ``written`` gives the LaTeX of formulas."""
    shown = json.dumps(document, ensure_ascii=False, indent=2, allow_nan=False, default=written)
    return shown + "\n"
