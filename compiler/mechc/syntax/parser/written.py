"""How each statement is written: an example by its word, for hints."""

from collections.abc import Sequence
from typing import Final

from .grammar import spelling
from .lalr import Token

WRITTEN: Final = {
    "mechc": "mechc 1",
    "mechanism": 'mechanism clamp "Toggle clamp"',
    "source": 'source "Artobolevsky, vol. 1, no. 14"',
    "param": "param a = 40 mm in 30 mm .. 50 mm",
    "drive": "drive phi from 10 deg to 80 deg",
    "pivot": "pivot O at (0 mm, 0 mm)",
    "slider": "slider K along 90 deg",
    "link": "link OAB",
    "slide": "slide WXY along x",
    "slot": "slot B in OC",
    "slot about": "slot B in OAC about C radius 30 mm",
    "telescope": "telescope AB",
    "gear": "gear O1 20 mm, O2 30 mm",
    "rack": "rack A on O 20 mm",
    "contact": "contact A on WX normal 80 deg",
    "belt": "belt O1 20 mm, O2 30 mm",
    "screw": "screw A pitch 5 mm on OB",
    "rope": "rope A, K along -y, B along y",
    "angle": "angle ABC = 30 deg",
    "assembly": "assembly ABC ccw",
    "mirror": "mirror across 90 deg sharing K",
    "copies": "copies 3 sharing K",
    "force": "force F at A along x",
    "torque": "torque M on OA",
    "actuator": "actuator P between A and B",
    "spring": "spring 5 N/mm between A and B free 40 mm",
    "weight": "weight W mass 2 kg at G",
    "load": "load Q intensity 5 N/mm on AB along -y",
    "gravity": "gravity along -y",
    "friction": "friction pins 0.1 diameter 10 mm",
    "friction pin": "friction pin A 0.1 diameter 10 mm",
    "friction slider": "friction slider K 0.1",
    "friction slider guide": "friction slider K 0.1 guide 60 mm overhang 40 mm",
    "friction roller": "friction roller A 0.1 axle 10 mm wheel 40 mm",
    "friction contact": "friction contact A 0.1",
    "friction gear": "friction gear O1 0.02",
    "friction belt": "friction belt O1 0.02",
    "friction rack": "friction rack A 0.02",
    "friction screw": "friction screw A 0.1 thread 20 mm",
    "friction collar": "friction collar A 0.1 mean 30 mm",
    "friction rope": "friction rope B 0.2 wrap 180 deg",
    "motion": "motion releasing",
    "efficiency": "efficiency 0.9",
    "sheet": 'sheet pin "Pin in shear"',
    "table": 'table m "Table 4.9" = 1: 0.388, 0.5: 0.541',
    "list": 'list bores "ISO 15552" = 32 mm, 40 mm, 50 mm',
    "use": "use cylinder as cyl (P = 2 kN)",
    "use joining": "use toggle_clamp as T joining T.H = B",
    "translate": 'translate "handle" uk "рукоятка" ru "рукоятка"',
    "let": "let F = 2 kN",
    "let at": "let q = m at 2*r/d",
    "let exactly": "let p = pitches at exactly d",
    "let next": "let D = next D_min in bores",
    "let when": "let K = 1.1 when v < 1 m/s else 1.3",
    "find": "find k = P/F",
    "require": "require 0 deg < alpha < 90 deg",
    "expect": "expect k = 0.353 at alpha = 10 deg",
    "report": "report plot k over alpha",
}
"""A whole line by its first word; by two or three where one word begins several statements."""

OPENING: Final = frozenset({"=", "..", "@"})
"""Signs that belong to a statement, not to an expression in it."""


def example(line: Sequence[Token], allowed: set[str]) -> str:
    """Return how the statement is written, '' within an expression, where no word is missing.

    >>> from .grammar import lexed
    >>> example(list(lexed("slider K 90")), {"ALONG"})
    'it is written: slider K along 90 deg'
    """
    may_follow = {spelling().get(name, "") for name in allowed}
    if not (allowed <= {"NAME"} or any(w.isalpha() or w in OPENING for w in may_follow)):
        return ""
    return whole_example(line)


def whole_example(line: Sequence[Token]) -> str:
    """Return how a statement is written, '' where no example is known."""
    meant = _example(line)
    return f"it is written: {meant}" if meant else ""


def words_behind(line: Sequence[Token]) -> list[str]:
    """Return the words and signs of the statement's example, but for the one it begins with."""
    return _example(line).split()[1:]


def _example(line: Sequence[Token]) -> str:
    """Return the example that shares most words with a line from its beginning."""
    words = [str(token) for token in line]
    for name in sorted(WRITTEN, key=lambda name: -name.count(" ")):
        first, *others = name.split()
        if words[:1] == [first] and set(others) <= set(words):
            return WRITTEN[name]
    return ""
