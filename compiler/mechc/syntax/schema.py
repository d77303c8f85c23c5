"""The JSON Schema of YAML descriptions, made from the table of sections.

Editors complete and check with it while one types. ``python -m mechc.syntax.schema``
writes ``grammar/mechanism.schema.json``.
"""

import json
from typing import Any

from ..data_folders import data
from ..units import DIMENSIONS
from .yaml.section_table import FURTHER_KEYS, SECTIONS
from .yaml.sections import EntryKey, EntryShape, SectionEntry, ValueKind, YamlSection

Schema = dict[str, Any]

POINT = "[A-Z][0-9]*'*"
OF_USED = r"(?:[A-Za-z][A-Za-z0-9_']*\.)?"
ANY_NAME = "^[A-Za-z][A-Za-z0-9_']*$"

# YAML readers see numbers where mechc sees text, so both are let in.
EXPRESSION: Schema = {"type": ["string", "number"], "description": "an expression: 2*a, 40 mm"}
CARTESIAN: Schema = {"type": "array", "items": EXPRESSION, "minItems": 2, "maxItems": 2}
END: Schema = {
    "type": "string",
    "pattern": f"^{OF_USED}{POINT}(?: on {OF_USED}(?:{POINT}){{2,}})?$",
}
POLAR: Schema = {
    "type": "object",
    "properties": {"length": EXPRESSION, "angle": EXPRESSION},
    "minProperties": 1,
    "additionalProperties": False,
}


def points(least: int, most: int | None = None) -> Schema:
    """Return the schema of a name made of so many points."""
    times = f"{{{least},{'' if most is None else most}}}"
    return {"type": "string", "pattern": f"^{OF_USED}(?:{POINT}){times}$"}


KINDS: dict[ValueKind, Schema] = {
    ValueKind.NAME: {"type": "string", "pattern": ANY_NAME},
    ValueKind.HEADING: {"type": "string", "pattern": ANY_NAME},
    ValueKind.POINT: points(1, 1),
    ValueKind.POINTS: points(2),
    ValueKind.ROD: points(2, 2),
    ValueKind.CORNER: points(3, 3),
    ValueKind.BODY: points(1),
    ValueKind.PIN: {"type": "string", "pattern": f"^(?:pins|{OF_USED}{POINT})$"},
    ValueKind.PAIR: {"type": "array", "items": END, "minItems": 2, "maxItems": 2},
    ValueKind.RIM: {**EXPRESSION, "description": "a radius: 40 mm, m*z/2, 40 mm on OA"},
    ValueKind.ROUTE: {"type": "string", "description": "a rope: A, K along -y, B along y"},
    ValueKind.SHARED: {"anyOf": [points(1, 1), {"type": "array", "items": points(1, 1)}]},
    ValueKind.EXPRESSION: EXPRESSION,
    ValueKind.DIRECTION: {**EXPRESSION, "description": "a direction: 90 deg, x, -y, AB, perp AB"},
    ValueKind.VECTOR: {"anyOf": [EXPRESSION, CARTESIAN, POLAR]},
    ValueKind.CARTESIAN: {"anyOf": [CARTESIAN, {"type": "null"}]},
    ValueKind.PLACE: {"anyOf": [points(1, 1), CARTESIAN]},
    ValueKind.RANGE: {"type": ["string", "null"], "pattern": r"\.\."},
    ValueKind.RESULT: EXPRESSION,
    ValueKind.CONDITION: {"type": "string", "description": "a condition: 0 deg < alpha < 90 deg"},
    ValueKind.EXPECTATION: {"type": "string", "description": "k = 7.1 at alpha = 35 deg"},
    ValueKind.REPORTED: {"type": "string", "description": "scheme, k, plot k over alpha"},
    ValueKind.MEASURE: {**EXPRESSION, "description": "a value: 40 mm, 2*a, 40 mm +- 0.1 mm"},
    ValueKind.LET_VALUE: {
        **EXPRESSION,
        "description": "2*a, 1 when a < b else 2, m49 at r, next d in pins",
    },
    ValueKind.UNIT: {"type": "string", "description": "a unit: MPa, N*m"},
    ValueKind.ROWS: {"type": "array", "items": CARTESIAN, "minItems": 1},
    ValueKind.SIZES: {"type": "array", "items": EXPRESSION, "minItems": 1},
    ValueKind.USED: {
        "type": "string",
        "description": "a name of the library, or a path: jaws.mech",
    },
    ValueKind.GIVEN: {
        "type": "object",
        "patternProperties": {ANY_NAME: EXPRESSION},
        "additionalProperties": False,
        "description": "values of parameters: {F: 3 kN, d: d}",
    },
    ValueKind.JOINTS: {
        "type": "object",
        "patternProperties": {f"^{OF_USED}{POINT}$": points(1, 1)},
        "additionalProperties": False,
        "description": "points that become one: {T.C: B}",
    },
    ValueKind.NAMES: {
        "anyOf": [
            {"type": "string", "pattern": ANY_NAME},
            {"type": "array", "items": {"type": "string", "pattern": ANY_NAME}},
        ]
    },
    ValueKind.DIMENSION: {"enum": sorted(DIMENSIONS)},
    ValueKind.TEXT: {"type": ["string", "number", "null"]},
    ValueKind.FLAG: {"type": "boolean"},
    ValueKind.VERSION: {"enum": [1, "1"]},
}


def schema() -> Schema:
    """Return the JSON Schema (draft 2020-12) of a description in YAML."""
    properties: Schema = {}
    for section in SECTIONS:
        properties[section.name] = {"description": section.about, **section_schema(section)}
        properties |= {key.name: of_key(key) for key in section.beside}
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "mechc mechanism",
        "description": "A planar mechanism and what to derive of it.",
        "type": "object",
        "properties": properties,
        "additionalProperties": False,
        "dependentSchemas": {
            name: {"anyOf": [{"required": [section]} for section in owners]}
            for name, owners in FURTHER_KEYS.items()
        },
    }


def section_schema(section: YamlSection) -> Schema:
    """Return the schema of a section by its shape."""
    match section.shape:
        case EntryShape.ONE:
            return entry_schema(section.entries[0])
        case EntryShape.NAMED:
            return mapping_schema(section)
        case EntryShape.LISTED:
            item = entry_schema(section.entries[0])
            several: Schema = {"type": "array", "items": item}
            return {"anyOf": [several, item]} if section.entries[0].short else several
        case EntryShape.BARE:
            name = of_key(subject_of(section.entries[0]))
            both = {"type": "array", "items": {"anyOf": [name, mapping_schema(section)]}}
            return {"anyOf": [both, mapping_schema(section), name]}
        case EntryShape.EITHER:
            listed = {"type": "array", "items": EXPRESSION}
            return {"anyOf": [listed, mapping_schema(section), EXPRESSION]}


def mapping_schema(section: YamlSection) -> Schema:
    """Return the schema of names with entries; entries that share names share a mapping."""
    patterns: dict[str, list[SectionEntry]] = {}
    for entry in section.entries:
        # Entries distinguished by their keys have the name of the first: 'pins' or a point.
        namesake = entry if entry.short else section.entries[0]
        pattern = of_key(subject_of(namesake)).get("pattern", "")
        patterns.setdefault(pattern, []).append(entry)
    found = {pattern: value_schema(entries) for pattern, entries in patterns.items()}
    return {"type": "object", "patternProperties": found, "additionalProperties": False}


def value_schema(entries: list[SectionEntry]) -> Schema:
    """Return the schema of what stands behind a name: an entry, or several in a list."""
    one = entry_schema(entries[0]) if len(entries) == 1 else merged(entries)
    short = entries[0].short
    if short and short.kind in (
        ValueKind.VECTOR,
        ValueKind.CARTESIAN,
        ValueKind.ROWS,
        ValueKind.SIZES,
    ):
        return one
    return {"anyOf": [one, {"type": "array", "items": one}]}


def merged(entries: list[SectionEntry]) -> Schema:
    """Return the schema of a mapping that states several things at once."""
    keys = [key for entry in entries for key in entry.keys]
    together = {entry.keys[0].name: required(entry)[1:] for entry in entries}
    heads = [{"required": [entry.keys[0].name]} for entry in entries]
    found = object_schema(keys)
    found["dependentRequired"] = {k: v for k, v in together.items() if v} | dependent(keys)
    return {**found, "anyOf": heads}


def entry_schema(entry: SectionEntry) -> Schema:
    """Return the schema of one entry: its plain value, its mapping, or either."""
    forms: list[Schema] = []
    if entry.short:
        forms.append(of_key(entry.short))
    if entry.keys or entry.others:
        forms.append(with_others(entry))
    if not forms:
        return {"type": "null"}
    return forms[0] if len(forms) == 1 else {"anyOf": forms}


def with_others(entry: SectionEntry) -> Schema:
    """Return the schema of a mapping, keys that are points included."""
    found = object_schema(list(entry.keys))
    if needed := required(entry):
        found["required"] = needed
    if needs := dependent(list(entry.keys)):
        found["dependentRequired"] = needs
    if entry.others:
        found["patternProperties"] = {f"^{POINT}$": of_key(entry.others[0])}
        found["minProperties"] = len(entry.others) + len(required(entry))
        found["maxProperties"] = len(entry.others) + len(entry.keys)
    return found


def object_schema(keys: list[EntryKey]) -> Schema:
    """Return the schema of a mapping with these keys and no other."""
    properties = {key.name: of_key(key) for key in keys}
    return {"type": "object", "properties": properties, "additionalProperties": False}


def required(entry: SectionEntry) -> list[str]:
    """Return the keys that an entry must have."""
    return [key.name for key in entry.keys if key.required]


def dependent(keys: list[EntryKey]) -> Schema:
    """Return which keys need which others."""
    return {key.name: list(key.needs) for key in keys if key.needs}


def subject_of(entry: SectionEntry) -> EntryKey:
    """Return the key that names an entry."""
    assert entry.subject is not None
    return entry.subject


def of_key(key: EntryKey) -> Schema:
    """Return the schema of a value by its kind."""
    return {"enum": list(key.words)} if key.kind is ValueKind.WORD else KINDS[key.kind]


def written() -> str:
    """Return the schema as the text of its file."""
    return json.dumps(schema(), indent=2, ensure_ascii=False) + "\n"


if __name__ == "__main__":
    (data("grammar") / "mechanism.schema.json").write_text(written(), "utf-8")
