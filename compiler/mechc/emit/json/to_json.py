"""JSON: the whole result for other programs, described by ``grammar/result.schema.json``."""

import json

from ..target import Compiled, Emitted, Options
from .document import DOCUMENT
from .kinds import Json


class JsonTarget:
    """``--emit json``."""

    name = "json"
    suffixes = (".json",)

    def emit(self, compiled: Compiled, options: Options) -> tuple[Emitted, ...]:
        """Return the document; NaN and infinities are null."""
        return (Emitted(f"{options.stem}.json", _text(DOCUMENT.write(compiled))),)


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


def _text(document: Json) -> str:
    return json.dumps(document, ensure_ascii=False, indent=2, allow_nan=False) + "\n"
