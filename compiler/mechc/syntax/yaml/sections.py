"""What the table of YAML's sections is made of: sections, entries, keys, kinds of values.

A section is a key at the top. Its entries become statements of the tree; an entry says
which node it makes, what its key names, what a plain value means, and which keys its
mapping form has.
"""

from enum import Enum, auto

from ...base.named import NamedTuple
from .. import ast


class ValueKind(Enum):
    """What a value is, and so how it is read, printed and described in the schema."""

    NAME = auto()
    HEADING = auto()  # a name that may be any word
    POINT = auto()
    POINTS = auto()
    ROD = auto()
    CORNER = auto()
    BODY = auto()
    PIN = auto()  # a point, or the word 'pins' for all of them
    PAIR = auto()  # [A, B on BC]
    RIM = auto()  # 40 mm on OA
    ROUTE = auto()  # A, K along -y, B along y
    SHARED = auto()  # [K, L]
    EXPRESSION = auto()
    DIRECTION = auto()
    VECTOR = auto()  # l @ alpha, {length: l, angle: alpha} or [x, y]
    CARTESIAN = auto()  # [x, y]
    PLACE = auto()  # a point or [x, y]
    RANGE = auto()
    RESULT = auto()
    CONDITION = auto()
    EXPECTATION = auto()
    REPORTED = auto()  # scheme, k, plot k over alpha
    MEASURE = auto()  # 40 mm +- 0.1 mm
    LET_VALUE = auto()  # 2*a, 1 when a < b else 2, m49 at r, next d in pins
    UNIT = auto()
    ROWS = auto()  # [[1, 0.388], [0.9, 0.400]]
    SIZES = auto()  # [32 mm, 40 mm]
    USED = auto()  # a name of the library, or a path
    GIVEN = auto()  # {F: 3 kN, d: d}
    JOINTS = auto()  # {T.C: B}
    NAMES = auto()  # [F, alpha]
    DIMENSION = auto()
    TEXT = auto()
    WORD = auto()
    FLAG = auto()
    VERSION = auto()


class EntryKey(NamedTuple):
    """A key of a mapping, or a plain value: its kind and the fields of the node it fills."""

    name: str
    kind: ValueKind
    fields: tuple[str, ...]
    required: bool = False
    words: tuple[str, ...] = ()
    needs: tuple[str, ...] = ()


class SectionEntry(NamedTuple):
    """One statement: the node, what names it, its plain value, its keys.

    ``others`` are keys that are points themselves: ``{O1: r1, O2: r2}``; each fills a
    field with the point, and others with the value.
    """

    node: type[ast.Statement]
    subject: EntryKey | None = None
    short: EntryKey | None = None
    keys: tuple[EntryKey, ...] = ()
    others: tuple[EntryKey, ...] = ()


class EntryShape(Enum):
    """How the entries of a section stand."""

    ONE = auto()  # gravity: -y
    NAMED = auto()  # params: {a: 40 mm}
    BARE = auto()  # pivots: [O, C], or {O: [x, y]}
    LISTED = auto()  # springs: [{…}, {…}]
    EITHER = auto()  # find: {k: P/F}, or [P, V_D/V_A]


class YamlSection(NamedTuple):
    """A key at the top of a description; ``beside`` are further keys at the top."""

    name: str
    about: str
    shape: EntryShape
    entries: tuple[SectionEntry, ...]
    beside: tuple[EntryKey, ...] = ()


def key(name: str, kind: ValueKind, *fields: str, required: bool = True) -> EntryKey:
    """Return a key that fills the field of its own name unless others are given."""
    return EntryKey(name, kind, fields or (name,), required)


def optional(name: str, kind: ValueKind, *fields: str, needs: tuple[str, ...] = ()) -> EntryKey:
    """Return a key that may be left out; it may need others with it."""
    return EntryKey(name, kind, fields or (name,), needs=needs)


def word(name: str, field: str, *words: str, needs: tuple[str, ...] = ()) -> EntryKey:
    """Return an optional key whose value is one of a few words."""
    return EntryKey(name, ValueKind.WORD, (field,), False, words, needs)


def plain(kind: ValueKind, *fields: str, words: tuple[str, ...] = ()) -> EntryKey:
    """Return the key of a plain value."""
    return EntryKey("", kind, fields, True, words)


def one(
    name: str, about: str, node: type[ast.Statement], short: EntryKey, *beside: EntryKey
) -> YamlSection:
    """Return a section that is one plain value."""
    return YamlSection(name, about, EntryShape.ONE, (SectionEntry(node, None, short),), beside)


def named(name: str, about: str, *entries: SectionEntry) -> YamlSection:
    """Return a section that maps names or points to entries."""
    return YamlSection(name, about, EntryShape.NAMED, entries)


def bare(name: str, about: str, entry: SectionEntry) -> YamlSection:
    """Return a section of names or points, each perhaps with a value."""
    return YamlSection(name, about, EntryShape.BARE, (entry,))


def listed(name: str, about: str, entry: SectionEntry) -> YamlSection:
    """Return a section that is a list of entries without names."""
    return YamlSection(name, about, EntryShape.LISTED, (entry,))
