"""What people mean by YAML that does not fit: a hint for each of the usual slips, and its place."""

import re
from collections.abc import Collection, Iterable, Mapping
from typing import Final

from ...base.later import pattern
from ...base.named import NamedTuple
from ...diagnostics import Diagnostic, syntax
from ...source import Source, Span
from ..examples import SECTIONS
from ..vocabulary import POINTS

GLUED: Final = pattern(
    r"^\s*(?:- )?([A-Za-z][\w']*):([^\s/:'\"][^:\n]*?)\s*(?:\n[^\n]*)?\Z", re.MULTILINE
)
"""A key and its value with no space behind the colon, in the last two lines of a text."""

ASSIGNED: Final = pattern(r"^\s*(?:- )?([A-Za-z][\w']*)\s*=\s*([^:\n#]*?)\s*(?:#.*)?$")
"""A line of the other notation, ``a = 40 mm``, where YAML has a key and a colon."""

ENTRY: Final = pattern(r"^( *)([A-Za-z][\w']*): +[^#\s]")
"""A line with a key and its value."""

DECIMAL: Final = pattern(r"(?<![\w.])(\d+),(\d+)(?=\s*(?:[A-Za-z°\"@]|(?P<end>[\],}\n]|\Z)))")
"""A number with a comma, in which YAML begins another entry: ``[0,5 mm]``; it may be the last."""

SPLIT: Final = ("E108", "E118", "E124", "E125")
"""The errors that come of a number in two parts."""

MEANT: Final[Mapping[str, Collection[str]]] = {
    **dict.fromkeys(("result", "results", "output", "outputs", "asked"), ("find",)),
    **dict.fromkeys(("bars", "rods", "bodies", "members", "levers"), ("links",)),
    **dict.fromkeys(("parameters", "variables", "values", "constants", "dims"), ("params",)),
    **dict.fromkeys(("joints", "coordinates", "pins", "nodes", "positions"), ("points",)),
    **dict.fromkeys(("ground", "fixed", "supports", "bearings"), ("pivots",)),
    **dict.fromkeys(("moments", "couples"), ("torques",)),
    **dict.fromkeys(("motor", "input", "driver"), ("drive",)),
    **dict.fromkeys(("guides", "pistons"), ("sliders",)),
    **dict.fromkeys(("cylinders", "jacks"), ("telescopes",)),
    **dict.fromkeys(("vectors", "lengths", "angles"), ("geometry",)),
    **dict.fromkeys(("direction", "angle", "dir"), ("along", "angle", "normal")),
    **dict.fromkeys(("on", "point"), ("at", "link")),
    "link": ("in",),
    "slider": ("guide",),
    "m": ("mass",),
    "along": ("angle",),
    **dict.fromkeys(("min", "max", "limits"), ("range",)),
    **dict.fromkeys(("author", "reference", "book"), ("source",)),
    **dict.fromkeys(("friction", "coefficient"), ("f",)),
    **dict.fromkeys(("d", "pin_diameter"), ("diameter",)),
    **dict.fromkeys(("columns", "values", "data"), ("rows", "sizes")),
    **dict.fromkeys(("formula", "expression"), ("value",)),
    **dict.fromkeys(("ua", "ukrainian"), ("uk",)),
    **dict.fromkeys(("stiffness", "k", "c"), ("rate",)),
    "name": ("mechanism",),
    "file": ("name",),
    "label": ("title",),
    "description": ("title", "label"),
}
"""The keys that people may mean by another one, the first that a place has."""

SAID: Final[Mapping[str, str]] = {
    "<<": "mappings are not merged: write the entries themselves",
    "units": "each number has its unit behind it: 40 mm",
    "version": "the version of the language is a key of its own: mechc: 1",
    "from": "a range has two dots: {phi: 10 deg .. 80 deg}",
    "size": "a load has its value by a let: let: {F: 20 N}",
    "file": "rows stand in the description: rows: [[1, 0.388], [0.9, 0.400]]",
    "tolerance": "a tolerance stands behind the value: 40 mm +- 0.1 mm",
    "mu": "a coefficient is f of a pin, guide of a slider, contact of a point that touches",
    "unit": "a unit stands behind its number: {value: 200 mm}",
    "value": "a load has its value by a let: let: {F: 20 N}",
}


FRICTIONS: Final[Mapping[str, str]] = {
    **dict.fromkeys(("pin", "pins"), "f: 0.1, diameter: 10 mm"),
    **dict.fromkeys(("slider", "guide"), "guide: 0.1"),
    "contact": "contact: 0.1",
    "rope": "rope: 0.2, wrap: 180 deg",
    "collar": "collar: 0.1, mean: 30 mm",
    "screw": "screw: 0.1, thread: 20 mm",
    "roller": "roller: 0.1, axle: 10 mm, wheel: 40 mm",
}
"""What stands below a point that has friction, by the word of the other notation."""

COMPONENTS = "components are a list: [20 mm, 35 mm]"


def written(section: str, key: str = "") -> str:
    """Return the hint that shows how a section, or a key in it, is written, '' where none is known.

    >>> written("friction", "K")
    'it is written: K: {guide: 0.1}, at a pin K: {f: 0.1, diameter: 10 mm}'
    """
    if section == "friction" and POINTS.fullmatch(key):
        return f"it is written: {key}: {{guide: 0.1}}, at a pin {key}: {{f: 0.1, diameter: 10 mm}}"
    return f"it is written: {section}: {SECTIONS[section]}" if section in SECTIONS else ""


class YamlSlip(NamedTuple):
    """Where a slip is, and the hint about it."""

    at: int
    hint: str


def of_text(text: str, at: int, problem: str, opened: int | None) -> YamlSlip:
    """Return the slip in text that is no YAML; ``opened`` is where a bracket opens."""
    found = text[at : at + 1]
    if "unexpected end of stream" in problem or "quoted scalar" in problem:
        return YamlSlip(opened if opened is not None else at, "this quote is not closed")
    if found == "@":
        return YamlSlip(at, "a value cannot begin with '@': write {angle: …}")
    if found in ("`", "%"):
        return YamlSlip(at, f"a value that begins with {found} needs quotes")
    if found == "\t":
        return YamlSlip(at, "YAML is indented with spaces")
    if slip := GLUED.search(text[:at]):
        return YamlSlip(slip.start(1), f"a colon needs a space behind it: {slip[1]}: {slip[2]}")
    if opened is not None:
        is_open = "\n" in text[opened:at]
        bracket = f"this '{text[opened : opened + 1]}' is not closed"
        return (
            YamlSlip(opened, bracket) if is_open else YamlSlip(at, "entries are parted by commas")
        )
    if "mapping" in problem and (hint := _indented(text, at, "values" not in problem)):
        return YamlSlip(at, hint)
    if "mapping values" in problem or "expected ':'" in problem:
        quotes = "a text with ': ' inside needs quotes" if "mapping values" in problem else ""
        return _assigned(text, at) or YamlSlip(at, quotes or "a key of YAML ends in ':'")
    if "<block end>" in problem:
        return _assigned(text, at) or YamlSlip(
            at, "entries of one list all begin with '-', those of a mapping never do"
        )
    return YamlSlip(at, "")


def _indented(text: str, at: int, either: bool) -> str:
    """Return the hint at an entry that is indented more than the one above, or ``either`` way."""
    above, _, line = text[:at].rpartition("\n")
    entry = ENTRY.match(above.rpartition("\n")[2])
    by = len(line) - len(line.lstrip()) - len(entry[1]) if entry else 0
    if not entry or not (by > 0 or (by and either)):
        return ""
    how = "more" if by > 0 else "less"
    return f"it is indented {how} than '{entry[2]}': entries of one mapping are in one column"


def _assigned(text: str, at: int) -> YamlSlip | None:
    """Return the slip of a line with ``=`` for a colon: that of the place, or the one above."""
    start = text.rfind("\n", 0, at) + 1
    for line in (text[start:].partition("\n")[0], text[:start].rstrip().rpartition("\n")[2]):
        if slip := ASSIGNED.match(line):
            return YamlSlip(text.rindex(line, 0, at + len(line)) + slip.start(1), _with_colon(line))
    return None


def _with_colon(text: str) -> str:
    slip = ASSIGNED.match(text)
    return f"in YAML a colon stands for '=': {slip[1]}: {slip[2]}" if slip else ""


def decimal_comma(fault: Diagnostic, source: Source) -> Diagnostic:
    """Return an error that a decimal comma caused as one about the comma, others as they are.

    What follows the comma is an entry of its own, and has the error; a list of whole numbers,
    ``[1,2,3]``, is written so, too.
    """
    if fault.code not in SPLIT or fault.span is None:
        return fault
    begun = source.text.rfind("\n", 0, fault.span.start) + 1
    last = source.text.find("\n", fault.span.end)
    for found in DECIMAL.finditer(source.text, begun, last if last > 0 else len(source.text)):
        is_inside = fault.span.start <= found.start() < fault.span.end and not found["end"]
        comma = found.end(1)
        if is_inside or fault.span.start in (comma + 1, found.end()):
            hint = f"decimals are written with a point: {found[1]}.{found[2]}"
            return syntax.unexpected_text(Span(comma, comma + 1), "','", ["'.'"], hint)
    return fault


def of_shape(text: str) -> str:
    """Return a hint at a plain value where a mapping belongs.

    >>> of_shape("OB = l @ alpha BK = l @ beta")
    "in YAML a colon stands for '=': OB: …"
    """
    first = re.match(r"([A-Za-z][\w']*)\s*=", text)
    return f"in YAML a colon stands for '=': {first[1]}: …" if first else ""


def of_text_in_keys(keys: Iterable[str]) -> str:
    """Return a hint at a mapping where a text belongs: vectors of a link, or other languages.

    >>> of_text_in_keys(["OA"])
    'lengths and directions stand apart: geometry: {OA: …}'
    """
    first = next(iter(keys), "")
    if POINTS.fullmatch(first) and len(first) > 1:
        return f"lengths and directions stand apart: geometry: {{{first}: …}}"
    return "other languages stand apart: translate: [{text: …, uk: …}]"


def of_section(key: str, allowed: Iterable[str]) -> str:
    """Return a hint at a key that a description does not have: a line of a section, misplaced.

    >>> of_section("BK", ["geometry", "links"])
    "it is a line of 'geometry' or 'links': indent it below that key"
    """
    if POINTS.fullmatch(key) and len(key) > 1:
        return "it is a line of 'geometry' or 'links': indent it below that key"
    return of_key(key, allowed)


def of_joint(where: str, key: str) -> str:
    """Return a hint at a point below the kind of its friction, '' for anything else.

    >>> of_joint("rope", "O")
    'friction has the point first: friction: {O: {rope: 0.2, wrap: 180 deg}}'
    """
    if where not in FRICTIONS or not POINTS.fullmatch(key):
        return ""
    return f"friction has the point first: friction: {{{key}: {{{FRICTIONS[where]}}}}}"


def of_key(key: str, allowed: Iterable[str]) -> str:
    """Return a hint at a key that a place does not have, '' where none is known.

    >>> of_key("bars", ["links", "params"]), of_key("on", ["at", "along"])
    ("did you mean 'links'?", "did you mean 'at'?")
    """
    known = set(allowed)
    if "rows" in known and key[:1].isdigit():
        return "the rows of a table are a list: {rows: [[1, 0.388], [0.5, 0.541]]}"
    meant = next((name for name in MEANT.get(key.lower(), ()) if name in known), "")
    return f"did you mean '{meant}'?" if meant else SAID.get(key, "")
