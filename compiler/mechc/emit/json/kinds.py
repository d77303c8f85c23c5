"""Kinds of JSON values: each knows how to write one and how to describe it.

A document is built from kinds, and its JSON Schema from the same kinds, so that the
two cannot drift apart.
"""

import math
from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Generic, TypeAlias, TypeVar

from ...base.frozen import frozen
from ...formula.tree import Formula

Json: TypeAlias = "bool | int | float | str | list[Json] | dict[str, Json] | Formula | None"
"""A value of a document; a formula stands for its LaTeX, which the document's writer makes."""

T = TypeVar("T")
R = TypeVar("R")


@frozen
class JsonKind(Generic[T]):
    """A kind of value: its schema, its writer, and the named schemas it refers to."""

    schema: dict[str, Json]
    write: Callable[[T], Json]
    definitions: Mapping[str, Json] = MappingProxyType({})


@frozen
class RecordField(Generic[R]):
    """A member of a record of R: its name, what it means, and its value's kind."""

    name: str
    schema: dict[str, Json]
    write: Callable[[R], Json]
    definitions: Mapping[str, Json]


def member(name: str, about: str, kind: JsonKind[T], read: Callable[[R], T]) -> RecordField[R]:
    """Return a member; ``read`` takes its value from the record's."""
    described: dict[str, Json] = {"description": about, **kind.schema}
    return RecordField(name, described, lambda value: kind.write(read(value)), kind.definitions)


def record(name: str, about: str, *fields: RecordField[R]) -> JsonKind[R]:
    """Return the kind of objects that have exactly these members."""
    shape: dict[str, Json] = {
        "description": about,
        "type": "object",
        "properties": {f.name: f.schema for f in fields},
        "required": [f.name for f in fields],
        "additionalProperties": False,
    }
    definitions = {key: value for f in fields for key, value in f.definitions.items()}
    return JsonKind(
        {"$ref": f"#/$defs/{name}"},
        lambda value: {f.name: f.write(value) for f in fields},
        {**definitions, name: shape},
    )


def list_of(kind: JsonKind[T]) -> "JsonKind[tuple[T, ...]]":
    """Return the kind of lists."""
    schema: dict[str, Json] = {"type": "array", "items": kind.schema}
    return JsonKind(schema, lambda values: [kind.write(v) for v in values], kind.definitions)


def map_of(kind: JsonKind[T]) -> JsonKind[Mapping[str, T]]:
    """Return the kind of objects with names of the description as keys."""
    schema: dict[str, Json] = {"type": "object", "additionalProperties": kind.schema}
    return JsonKind(
        schema, lambda values: {k: kind.write(v) for k, v in values.items()}, kind.definitions
    )


def optional(kind: JsonKind[T]) -> JsonKind[T | None]:
    """Return the kind that may also be null."""
    schema: dict[str, Json] = {"anyOf": [kind.schema, {"type": "null"}]}
    return JsonKind(schema, lambda v: None if v is None else kind.write(v), kind.definitions)


def any_of(kinds: Mapping[type[T], JsonKind[T]]) -> JsonKind[T]:
    """Return the kind of values of several classes, each with a kind of its own."""
    definitions = {
        name: shape for kind in kinds.values() for name, shape in kind.definitions.items()
    }
    shapes: list[Json] = [kind.schema for kind in kinds.values()]
    return JsonKind({"anyOf": shapes}, lambda value: kinds[type(value)].write(value), definitions)


def one_of(*words: str) -> JsonKind[str]:
    """Return the kind of a word from a fixed list."""
    return JsonKind({"enum": list(words)}, str)


def _finite(value: float | None) -> Json:
    return value if value is not None and math.isfinite(value) else None


TEXT: JsonKind[str] = JsonKind({"type": "string"}, str)
WHOLE: JsonKind[int] = JsonKind({"type": "integer"}, int)
TRUTH: JsonKind[bool] = JsonKind({"type": "boolean"}, bool)
FLOAT: JsonKind[float | None] = JsonKind({"type": ["number", "null"]}, _finite)
"""A number; null where there is none, as JSON has neither NaN nor infinity."""
