"""Slips of the pen: one line of a right description written as a person does by mistake."""

import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from random import Random
from typing import NamedTuple

from mechc.diagnostics import Report
from mechc.source import Source
from mechc.syntax.notation import read
from mechc.syntax.to_yaml import to_yaml
from paths import CORPUS, LIBRARY, ROOT

NUMBER = r"(?<![\w.^-])(?!0+(?:\.0*)? )(\d[\d.]*)"
UNIT = r"(mm|deg|kN|kg|N|m)(?![\w^/*'])"
SIZE = rf"{NUMBER} {UNIT}"
NAME = r"\b([a-z]\w*)\b"
POINT = r"\b([A-Z][0-9']*)"
BODY = r"\b([A-Z][0-9']*[A-Z][0-9']*)\b"


class Kind(NamedTuple):
    """A slip: what stands in a right line (a pattern), and what is written instead."""

    name: str
    meant: str
    written: str


class Slip(NamedTuple):
    """A description with one slip in one line."""

    kind: str
    path: Path
    text: str
    line: int
    written: str

    @property
    def source(self) -> Source:
        """Return the text with its name and folder."""
        return Source(self.path.name, self.text, folder=self.path.parent)


IN_LINES = (
    # words
    Kind("letter lost", r"^(\s*)(\w{2})\w(\w{2,}) ", r"\1\2\3 "),
    Kind("letter twice", r"^(\s*)(\w{2})(\w)(\w+) ", r"\1\2\3\3\4 "),
    Kind("letters exchanged", r"^(\s*[a-z])([a-z])(?!\2)([a-z])(\w*) ", r"\1\3\2\4 "),
    Kind("plural", r"^(pivot|slider|link|force|torque|spring|slot|gear|let|param)\b", r"\1s"),
    Kind("capital", r"^(pivot|slider|link|force|torque|param|let|find|drive|assembly)\b", "X"),
    Kind("another language", r"^(pivot|slider|link|force|param|find)\b", "шарнир"),
    Kind("word of another program", r"^param\b", "var"),
    Kind("word of a drawing", r"^pivot\b", "ground"),
    Kind("joint of a book", r"^link\b", "rod"),
    Kind("load of a book", r"^force\b", "load"),
    Kind("moment", r"^torque\b", "moment"),
    Kind("guide", r"^slider\b", "guide"),
    Kind("prismatic", r"^slider (\w+) along", r"slider \1 on"),
    Kind("preposition", r"^(force|weight) (.*?) at ", r"\1 \2 on "),
    Kind("preposition of a couple", r"^torque (\w+) on ", r"torque \1 at "),
    Kind("between by a comma", r" between (\w+) and (\w+)", r" between \1, \2"),
    Kind("from without to", r"^(drive .* from .*?) to ", r"\1 "),
    Kind("stroke as a range", r"^(drive .*) from (.*?) to ", r"\1 in \2 .. "),
    Kind("along left out", r"^(slider|force) (.*?) along ", r"\1 \2 "),
    Kind("in left out", r'^(param [^"#]*?) in ', r"\1 "),
    # signs
    Kind("equals twice", r"^((?:param|let|find|\w+) *[\w']*) = ", r"\1 == "),
    Kind("equals of Pascal", r"^((?:param|let) +\w+) += ", r"\1 := "),
    Kind("colon", r"^((?:param|let) +\w+) += ", r"\1: "),
    Kind("equals left out", r"^((?:param|let|expect) +\w+) += ", r"\1 "),
    Kind("at sign left out", r" @ ", " "),
    Kind("at sign twice", r" @ ", " @ @ "),
    Kind("three dots", r" \.\. ", " ... "),
    Kind("dash for a range", r" \.\. ", " - "),
    Kind("words for a range", r" \.\. ", " to "),
    Kind("comma in a number", r"\b(\d+)\.(\d+)", r"\1,\2"),
    Kind("space in a number", rf"\b(\d)(\d\d+) {UNIT}", r"\1 \2 \3"),
    Kind("comma of thousands", rf"\b(\d)(\d\d) {UNIT}", r"\1,\g<2>0 \3"),
    Kind("two points", r"\b(\d+)\.(\d+)", r"\1.\2.\2"),
    Kind("power of Python", r"\^", "**"),
    Kind("power raised", r"\^2", "²"),
    Kind("product left out", r"(\w)\*(\w)", r"\1 \2"),
    Kind("operator twice", r" ([+*/]) ", r" \1 \1 "),
    Kind("operand left out", r"([+*/])(\s*)[\w.]+$", r"\1"),
    Kind("bracket open", r"^([^#\"]*)\)", r"\1"),
    Kind("bracket closed", r"^([^#\"]*)\(", r"\1"),
    Kind("square brackets", r"\(([^()]*)\)$", r"[\1]"),
    Kind("semicolon of C", r"^(?!.*\")(\w.*\w)$", r"\1;"),
    Kind("full stop", r"^(?!.*\")(\w.*[a-z])$", r"\1."),
    Kind("comma at the end", r"^(?!.*\")(\w.*\w)$", r"\1,"),
    Kind("comment of C", r"^(?!.*\")(\w.*\w)$", r"\1 // see fig. 2"),
    Kind("comment of TeX", r"^(?!.*\")(\w.*\w)$", r"\1 % see fig. 2"),
    Kind("quote left out", r"^((?:mechanism|source) [^\"]*)\"", r"\1"),
    Kind("quote open", r"^((?:mechanism|source) .*)\"$", r"\1"),
    Kind("name in quotes", r"^(param|pivot|link|let) (\w+)", r'\1 "\2"'),
    # values
    Kind("unit left out", SIZE, r"\1"),
    Kind("unit of mass", rf"{NUMBER} (mm|deg|m|N)(?![\w^/*'])", r"\1 kg"),
    Kind("unit of time", SIZE, r"\1 s"),
    Kind("unit of a spring", SIZE, r"\1 N/mm"),
    Kind("unit with a slip", rf"{NUMBER} (mm|deg|kN|kg)(?![\w^/*'])", r"\1 \2\2"),
    Kind("unit in capitals", rf"{NUMBER} deg", r"\1 DEG"),
    Kind("millimetres in capitals", rf"{NUMBER} mm", r"\1 MM"),
    Kind("unit of another language", rf"{NUMBER} mm", r"\1 мм"),
    Kind("unit twice", SIZE, r"\1 \2 \2"),
    Kind("unit in brackets", SIZE, r"\1 [\2]"),
    Kind("unit before", SIZE, r"\2 \1"),
    Kind("inches", rf"{NUMBER} mm", r"\1 inches"),
    Kind("minutes of arc", rf"{NUMBER} deg", r"\1° 30'"),
    Kind("no number", SIZE, r"nan \2"),
    Kind("infinite", SIZE, r"inf \2"),
    Kind("too large", SIZE, r"1e999 \2"),
    Kind("too small", rf"^(param +\w+ +=) +{NUMBER} (mm|m)", r"\1 1e-400 \3"),
    Kind("negative length", rf"^([A-Z]\w* =) {NUMBER} (mm|m)", r"\1 -\2 \3"),
    Kind("beyond its range", rf"^(param .*=) .* in {NUMBER} (\S+) ", r"\1 0.01*\2 \3 in \2 \3 "),
    Kind("range turned round", r"^(param .* in) (\d.*?) \.\. (\d.*)$", r"\1 \3 .. \2"),
    Kind("stroke of no length", r"^(drive .* from) (\d.*?) to \d.*$", r"\1 \2 to \2"),
    Kind("degrees without a name", r"along ([1-9]\d*) deg", r"along \1"),
    Kind("a word for a direction", r"along (\S+)$", "along up"),
    Kind("axis in capitals", r"along -?[xy]$", "along X"),
    Kind("third axis", r"along -?[xy]$", "along z"),
    # names
    Kind("unknown quantity", r"(= .*?)\b(?!deg|mm|kN)([a-z]\w*)\b(?![ (]*\()(?=[ *]|$)", r"\1\2q"),
    Kind("unknown point", r"^((?:force|weight) .* at) \w+", r"\1 X9"),
    Kind("unknown link", r"^(torque \w+ on) \w+", r"\1 X9Y"),
    Kind("unknown load", r"^(find \w+ = \w+)/\w+", r"\1/Q9"),
    Kind("unknown load above", r"^(find \w+ =) \w+/", r"\1 Q9/"),
    Kind("unknown shared point", r"^(mirror .* sharing) \w+", r"\1 X9"),
    Kind("unknown drive", r"^(drive) \w+", r"\1 q9"),
    Kind("unknown corner", r"^(assembly \w)\w(\w+)", r"\1X\2"),
    Kind("point in small letters", r"^(pivot|slider) ([A-Z])\b", "pivot p"),
    Kind("link in small letters", r"^link ([A-Z]+)\b", "link ob"),
    Kind("link by a dash", rf"^link {POINT}([A-Z])", r"link \1-\2"),
    Kind("link by spaces", rf"^link {POINT}([A-Z])", r"link \1 \2"),
    Kind("quantity by a dash", r"^param ([a-z]\w*)", r"param \1-0"),
    Kind("quantity by a point", r"^param ([a-z]\w*)", r"param \1.0"),
    Kind("reserved word", r"^param ([a-z]\w*)", "param along"),
    Kind("function as a name", r"^param ([a-z]\w*)", "param sin"),
    Kind("vector of one point", rf"^{POINT}[A-Z][0-9']* = ", r"\1 = "),
    Kind("vector of three points", rf"^{BODY} = ", r"\1Z = "),
    Kind("vector to itself", rf"^{POINT}[A-Z][0-9']* = ", r"\1\1 = "),
    Kind("direction to itself", r"(= |@ )(.*)\bperp [A-Z]+", r"\1\2perp AA"),
    Kind("two loads below", r"^(find \w+ = \w+/\w+)$", r"\1/\1"),
    # functions
    Kind("function in capitals", r"\b(sin|cos|tan|sqrt)\(", "Sin("),
    Kind("function of Excel", r"\b(atan|asin|acos|sqrt)\(", "arcsinus("),
    Kind("function without brackets", r"\b(sin|cos|tan)\((\w+)\)", r"\1 \2"),
    Kind("two arguments", r"\b(sin|cos|tan|sqrt)\(([^()]*)\)", r"\1(\2, \2)"),
    Kind("no argument", r"\b(sin|cos|tan|sqrt)\(([^()]*)\)", r"\1()"),
    # loads and joints
    Kind("joint on two lines", r"^(pivot|slider) (\w+)(.*)$", r"\1 \2\3\nlink \2"),
    Kind("link of one point", rf"^link {POINT}.*$", r"link \1"),
    Kind("link with a point twice", rf"^link {POINT}([A-Z]\w*)", r"link \1\2\1"),
    Kind("load on another link", r"^(force \w+ at) ([A-Z][0-9']*) along", r"\1 \2 on XYZ along"),
    Kind("force without a direction", r"^(force \w+ at \w+) along .*$", r"\1"),
    Kind("couple with a direction", r"^(torque \w+ on \w+)$", r"\1 along x"),
    Kind("assembly right", r"^(assembly \w+) (cw|ccw)$", r"\1 right"),
    Kind("assembly of two points", r"^assembly (\w)(\w)(\w) ", r"assembly \1\2 "),
    Kind("assembly both ways", r"^assembly (\w+) (cw|ccw)$", r"assembly \1 cw\nassembly \1 ccw"),
    Kind("slider of two guides", r"^slider (\w+) along .*$", r"\g<0>\nslider \1 along 77 deg"),
    Kind("pivot and slider", r"^pivot (\w+)$", r"pivot \1\nslider \1 along x"),
    Kind("vector twice", rf"^{BODY} = (.*)$", r"\1 = \2\n\1 = 3 m @ 12.34 deg"),
    Kind("parameter twice", r"^(param (\w+) .*)$", r"\1\nparam \2 = 7.25"),
    Kind("friction twice", r"^(friction .*)$", r"\1\n\1"),
    Kind("friction of a percentage", r"^(friction (?:slider|contact|pin) \w+) \S+", r"\1 12 %"),
    Kind("friction with a unit", r"^(friction (?:slider|contact|gear) \w+) \S+", r"\1 0.1 mm"),
    Kind("negative friction", r"^(friction (?:slider|contact|gear) \w+) \S+", r"\1 -0.1"),
    Kind("diameter left out", r"^(friction pins? .*?) diameter .*$", r"\1"),
    Kind("diameter as a number", r"^(friction pins? .*? diameter) .*$", r"\1 20"),
    Kind("diameter in degrees", r"^(friction pins? .*? diameter) .*$", r"\1 20 deg"),
    Kind("friction of a load", r"^friction (slider|contact|pin) \w+", r"friction \1 P"),
    Kind("friction of an unknown joint", r"^friction (slider|contact|pin) \w+", r"friction \1 X9"),
    Kind("expectation with another sign", r"^expect (\w+) = (?!0)([^-+]*)$", r"expect \1 = -(\2)"),
    Kind("expectation twice as large", r"^expect (\w+) = ([^-+]*)$", r"expect \1 = 2*(\2)"),
    Kind("expectation of something else", r"^expect (\w+) = ", "expect q9 = "),
    # sheets and parts
    Kind("rows out of order", r"^(table .* =) (.*?), (.*?), (.*)$", r"\1 \3, \2, \4"),
    Kind("row without a value", r"^(table .* =) (.*?): [^,]*,", r"\1 \2,"),
    Kind("row twice", r"^(table .* =) (.*?), ", r"\1 \2, \2, "),
    Kind("sizes of another kind", r"^(list .* = \d+) mm", r"\1 deg"),
    Kind("sizes out of order", r"^(list .* =) (.*?), (.*?), (.*)$", r"\1 \3, \2, \4"),
    Kind("next of an unknown list", r" in (\w+)(?= *$)", " in q9"),
    Kind("next left out", r"= next ", "= "),
    Kind("case without when", r" when ", " if "),
    Kind("else first", r" when (.*) else (.*)$", r" else \2 when \1"),
    Kind("condition of two kinds", r"^(require .*) (<=|>=|<|>) .*$", r"\1 \2 3 kg"),
    Kind("result in a wrong unit", r"^(let .*) in (mm|MPa|N)\b", r"\1 in kg"),
    Kind("result in an unknown unit", r"^(let .*) in (mm|MPa|N)\b", r"\1 in \2q"),
    Kind("unknown sheet", r"^use [\w\"./]+", "use cylindre"),
    Kind("use without as", r"^(use [\w\"./]+) as ", r"\1 "),
    Kind("unknown argument", r"^(use .* as \w+) \((\w+) =", r"\1 (\2q ="),
    Kind("argument by a colon", r"^(use .* as \w+) \((\w+) =", r"\1 (\2:"),
    Kind("unknown point of a part", r"joining (\w+)\.(\w+) =", r"joining \1.X9 ="),
    Kind("unknown part", r"joining (\w+)\.(\w+) =", r"joining Q9.\2 ="),
    Kind("joined to a link", r"joining (\w+\.\w+) = (\w+)", r"joining \1 = AB"),
    Kind("joined by an arrow", r"joining (\w+\.\w+) = ", r"joining \1 -> "),
    Kind("joining left out", r" joining .*", ""),
)  # fmt: skip
"""Slips that no reading makes right: each is to be stated, at its line."""

IN_YAML = (
    Kind("tab", r"^  (\w)", "\t\\1"),
    Kind("space after a colon left out", r"^( *\w+): (\S)", r"\1:\2"),
    Kind("equals for a colon", r"^( *\w+): (\d)", r"\1 = \2"),
    Kind("singular", r"^(param|pivot|slider|link|force|torque)s:", r"\1:"),
    Kind("key in capitals", r"^(params|pivots|links|forces|geometry):", "PARAMS:"),
    Kind("key with a slip", r"^(\w{3})\w(\w+):", r"\1\2:"),
    Kind("comma left out", r"^( +.*\w), (\w.*[}\]])$", r"\1 \2"),
    Kind("brace open", r"^( +\w+: \{.*)\}$", r"\1"),
    Kind("bracket open", r"^( *\w+: \[.*)\]$", r"\1"),
    Kind("list for a value", r"^( +\w+: )(\d+) (mm|deg)$", r"\1[\2, \3]"),
    Kind("value left out", r"^( +\w+:) \S.*$", r"\1"),
    Kind("null", r"^( +\w+:) \S.*$", r"\1 ~"),
    Kind("yes", r"^( +\w+:) \d.*$", r"\1 yes"),
    Kind("unit left out", r"^( +\w+:) (\d+) (mm|deg)$", r"\1 \2"),
    Kind("key of another load", r"\{at: (\w+), along: ", r"{at: \1, direction: "),
    Kind("key of another place", r"\{at: (\w+), along: ", r"{point: \1, along: "),
    Kind("key too many", r"\{at: (\w+), along: ", r"{at: \1, size: 3 N, along: "),
    Kind("key twice", r"\{at: (\w+), along: ", r"{at: \1, at: \1, along: "),
    Kind("entry twice", r"^( +\w+: \S.*)$", r"\1\n\1"),
    Kind("infinite", r"^( +\w+: )\d+ (mm|deg)$", r"\1.inf"),
    Kind("no number", r"^( +\w+: )\d+ (mm|deg)$", r"\1.nan"),
    Kind("tag", r"^( +\w+: )(\d+ (?:mm|deg))$", r"\1!!float \2"),
    Kind("alias", r"^( +\w+: )(\d+ (?:mm|deg))$", r"\1*a"),
    Kind("nested too deep", r"^( +)(\w+): (\d+ (?:mm|deg))$", r"\1\2:\n\1  \2: \3"),
    Kind("text in the place of a mapping", r"^( +\w+: )\{.*\}$", r"\1all"),
    Kind("unit in quotes of their own", r"^( +\w+: )(\d+) (mm|deg)$", r"\1\2 '\3'"),
    Kind("range as a list", r"range: (.*?) \.\. (.*?)\}", r"range: [\1, \2]}"),
    Kind("three dots", r" \.\. ", " ... "),
    Kind("unknown point", r"\{at: (\w+)", "{at: X9"),
    Kind("unknown quantity", r"^( +[A-Z]\w*: )([a-z]\w*)( @)", r"\1\2q\3"),
    Kind("at sign left out", r" @ ", " "),
)
"""The same of YAML."""


@cache
def right(suffix: str) -> dict[Path, str]:
    """Return right descriptions in lines or in YAML."""
    folders = (LIBRARY, LIBRARY / "sheets", CORPUS / "good", ROOT / "examples")
    paths = [p for f in folders for p in f.glob("*") if p.suffix in (".mech", ".yaml")]
    paths += (ROOT / "examples").glob("*/*.mech")
    given = {p.with_suffix(suffix): _in(suffix, p) for p in sorted(paths)}
    return {path: text for path, text in given.items() if text}


def _in(suffix: str, path: Path) -> str:
    """Return a description in a notation; '' where it stands in YAML and lines are asked for."""
    text = path.read_text("utf-8")
    if path.suffix == suffix:
        return text
    source = Source(path.name, text)
    return to_yaml(read(source, Report(source))) if suffix == ".yaml" else ""


def drawn(kind: Kind, suffix: str, number: int, seed: int) -> list[Slip]:
    """Return some slips of a kind."""
    every = list(_places(kind, suffix))
    return [_made(kind, *place) for place in Random(seed).sample(every, min(number, len(every)))]


def _places(kind: Kind, suffix: str) -> Iterator[tuple[Path, int, str]]:
    """Yield the lines that a slip can be in, and what is written there."""
    for path, text in right(suffix).items():
        for number, line in enumerate(text.splitlines()):
            code, remark = _parted(line)
            if (written := _slip(kind, code)) != code:
                yield path, number, written if "\n" in written else written + remark


def _parted(line: str) -> tuple[str, str]:
    """Return a line without its remark, and the remark."""
    found = re.search(r"\s*(#.*)?$", line)
    assert found
    return line[: found.start()], found[0]


def _made(kind: Kind, path: Path, number: int, written: str) -> Slip:
    lines = right(path.suffix)[path].splitlines()
    lines[number] = written
    return Slip(kind.name, path, "\n".join([*lines, ""]), number + 1, written)


def _slip(kind: Kind, code: str) -> str:
    """Return a line with a slip, which is in no text of it."""
    found = re.search(kind.meant, code)
    before = code[: found.start()] if found else ""
    in_text = before.count('"') % 2 or re.search("'.* .*'", code)
    return code if in_text else re.sub(kind.meant, kind.written, code, count=1)
