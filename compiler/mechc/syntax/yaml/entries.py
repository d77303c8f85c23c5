"""One entry of a YAML section to one or more statements, as the table of sections says."""

from collections.abc import Iterable, Iterator
from typing import Any

from ...base.frozen import fields
from ...diagnostics import Diagnostic, syntax, syntax_yaml
from ...source import Source, Span
from .. import ast, examples
from ..fault import Fault
from ..vocabulary import points_of
from . import slips
from .nodes import Listing, Mapping, Scalar, YamlNode
from .scalars import described
from .sections import EntryKey, EntryShape, SectionEntry, ValueKind, YamlSection
from .values import values

KeyAndNode = tuple[Scalar, YamlNode]
ChosenEntry = tuple[SectionEntry, list[KeyAndNode] | None]
"""An entry and its keys; None where the value is a plain one."""


def statements(
    section: YamlSection, subject: Scalar | None, value: YamlNode, span: Span, source: Source
) -> Iterator[ast.Statement]:
    """Yield the statements of an entry: one, or several kinds of friction at one point."""
    where = subject.text if subject else section.name
    for entry, pairs in chosen(section, subject, value, where):
        if pairs is None:
            fields = plain_fields(entry, value, source, "" if subject else section.name)
        else:
            fields = mapping_fields(entry, pairs, value.span, where, source)
        yield made(entry, span, with_subject(fields, entry, subject, source))


def made(entry: SectionEntry, span: Span, fields: dict[str, Any]) -> ast.Statement:
    """Return the node, after the checks that the line notation makes in its grammar."""
    node = entry.node(span, **fields)
    if isinstance(node, ast.Param) and not (node.value or node.dimension or node.low):
        raise Fault(syntax.empty_parameter(node.name.span, node.name.text))
    return node


def chosen(
    section: YamlSection, subject: Scalar | None, value: YamlNode, where: str
) -> list[ChosenEntry]:
    """Return the entries that the keys speak of, each with its keys and values."""
    if len(section.entries) > 1 and not section.entries[0].short:
        return by_keys(section, table(value, where, section), where)
    entry = section.entries[0]
    if len(section.entries) > 1 and subject and len(points_of(subject.text)) == 3:
        entry = section.entries[1]
    if isinstance(value, Mapping) and (entry.keys or entry.others):
        return [(entry, list(value.entries))]
    return [(entry, None)]


def table(value: YamlNode, where: str, section: YamlSection) -> Mapping:
    """Return a mapping; refuse anything else, naming the keys that it would have."""
    if isinstance(value, Mapping):
        return value
    keys = [key.name for entry in section.entries for key in entry.keys]
    expected = f"a mapping with keys of {', '.join(keys)}"
    if section.name in examples.SECTIONS:
        expected = "a mapping"
    hint = slips.written(section.name, where)
    raise Fault(syntax_yaml.wrong_shape(value.span, described(value), expected, hint))


def by_keys(section: YamlSection, value: Mapping, where: str) -> list[ChosenEntry]:
    """Share the keys out among the entries whose first key is there."""
    given = {name.text for name, _ in value.entries}
    present = [entry for entry in section.entries if entry.keys[0].name in given]
    allowed = [key.name for entry in section.entries for key in entry.keys]
    for name, _ in value.entries:
        if name.text not in allowed:
            raise Fault(unknown_key(name, where, allowed))
        owner = next(e for e in section.entries if name.text in {key.name for key in e.keys})
        if owner not in present:
            lacking = [owner.keys[0].name]
            raise Fault(syntax_yaml.missing_key(name.span, lacking, f"'{where}'"))
    if not present:
        raise Fault(syntax_yaml.missing_key(value.span, [section.entries[0].keys[0].name], where))
    return [(entry, owned(entry, value.entries)) for entry in present]


def unknown_key(name: Scalar, where: str, allowed: Iterable[str]) -> Diagnostic:
    """Return the error about a key that an entry does not have."""
    hint = slips.of_joint(where, name.text) or slips.of_key(name.text, allowed)
    return syntax_yaml.unknown_key(name.span, name.text, f"'{where}'", allowed, hint)


def owned(entry: SectionEntry, pairs: Iterable[KeyAndNode]) -> list[KeyAndNode]:
    """Return the keys that belong to an entry."""
    names = {key.name for key in entry.keys}
    return [pair for pair in pairs if pair[0].text in names]


def with_subject(
    fields: dict[str, Any], entry: SectionEntry, subject: Scalar | None, source: Source
) -> dict[str, Any]:
    """Return the fields with those that the key of the entry fills; a name is given once."""
    if entry.subject is None or subject is None:
        return fields
    inner = fields.get("name")
    if isinstance(inner, ast.Name):
        expected = [f"what '{subject.text}' is, without a second name"]
        raise Fault(syntax.unexpected_text(inner.span, f"the name '{inner.text}'", expected))
    return fields | values(entry.subject, subject, source)


def plain_fields(
    entry: SectionEntry, value: YamlNode, source: Source, section: str
) -> dict[str, Any]:
    """Return the fields of an entry without keys of its own: ``K: 90 deg``.

    ``section`` is the one that it is alone in, if it is.
    """
    short = entry.short
    if short is None:
        return {} if empty(value) and not needs_keys(entry) else refused(entry, value, section)
    if empty(value) and all(optional_field(entry, field) for field in short.fields):
        return {}
    return values(short, value, source)


def needs_keys(entry: SectionEntry) -> bool:
    """Return whether an entry means nothing without its mapping form."""
    return bool(entry.others) or any(key.required for key in entry.keys)


def optional_field(entry: SectionEntry, name: str) -> bool:
    """Return whether the node can do without a field."""
    return any(f.name == name and f.default in (None, "") for f in fields(entry.node))


def empty(value: YamlNode) -> bool:
    """Return whether nothing was written."""
    return isinstance(value, Scalar) and value.empty


def refused(entry: SectionEntry, value: YamlNode, section: str) -> dict[str, Any]:
    """Refuse a plain value where only a mapping has a meaning."""
    keys = ", ".join(key.name for key in entry.keys)
    expected = f"a mapping with {keys}" if keys else "nothing behind it"
    wanted = ", ".join(f"{key.name}: …" for key in entry.keys if key.required)
    hint = slips.written(section) or (f"write {{{wanted}}}" if wanted else "")
    raise Fault(syntax_yaml.wrong_shape(value.span, described(value), expected, hint))


def mapping_fields(
    entry: SectionEntry, pairs: list[KeyAndNode], span: Span, where: str, source: Source
) -> dict[str, Any]:
    """Return the fields that the keys of a mapping fill."""
    known = {key.name: key for key in entry.keys}
    fields: dict[str, Any] = {}
    spare = list(entry.others)
    for name, value in pairs:
        if name.text in known:
            refuse_two_ends(known, name, value)
            fields |= values(known[name.text], value, source)
        elif spare and points_of(name.text):
            fields |= other_fields(spare.pop(0), name, value, source)
        else:
            raise Fault(unknown_key(name, where, known))
    check_keys(entry, {name.text for name, _ in pairs}, spare, span, where)
    return fields


def refuse_two_ends(known: dict[str, EntryKey], name: Scalar, value: YamlNode) -> None:
    """Refuse ``intensity: [q1, q2]``: the intensity at the other end has the key ``to``."""
    end = known.get("to")
    if end and name.text in end.needs and isinstance(value, Listing):
        hint = f"what varies evenly has two keys: {{{name.text}: q1, to: q2}}"
        raise Fault(syntax_yaml.wrong_shape(value.span, described(value), "an expression", hint))


def other_fields(key: EntryKey, name: Scalar, value: YamlNode, source: Source) -> dict[str, Any]:
    """Return the fields of ``O1: r1``: the point and what belongs to it."""
    point = EntryKey("", ValueKind.POINT, key.fields[:1])
    return values(point, name, source) | values(key._replace(fields=key.fields[1:]), value, source)


def check_keys(
    entry: SectionEntry, given: set[str], spare: list[EntryKey], span: Span, where: str
) -> None:
    """Refuse an entry that lacks a key, or has one that needs another."""
    if not given and not needs_keys(entry):
        return
    lacking = [key.name for key in entry.keys if key.required and key.name not in given]
    lacking += ["POINT: …"] * len(spare)
    for key in entry.keys:
        if key.name in given:
            lacking += [needed for needed in key.needs if needed not in given]
    if lacking:
        raise Fault(syntax_yaml.missing_key(span, dict.fromkeys(lacking), f"'{where}'"))


LISTS_THEMSELVES = (
    ValueKind.VECTOR,
    ValueKind.CARTESIAN,
    ValueKind.MEASURE,
    ValueKind.ROWS,
    ValueKind.SIZES,
)
"""Values that a list is, or that stand only once: it does not stand for several entries."""


def several(value: YamlNode, section: YamlSection) -> tuple[YamlNode, ...]:
    """Return the values of a key: a list stands for several, unless it is ``[x, y]``.

    A parameter has one value: a list of them is a mistake of its own.
    """
    short = section.entries[0].short
    single = short is not None and short.kind in LISTS_THEMSELVES
    listed = section.shape is EntryShape.NAMED and not single
    return value.items if listed and isinstance(value, Listing) else (value,)
