"""Diagnostics as text: the caret stands under the place whatever the line is made of."""

import json
import re

import pytest

from mechc.diagnostics import Diagnostic, Related
from mechc.diagnostics.render import LONGEST_EXCERPT, cut, render
from mechc.source import Source, Span


def shown(text: str, part: str, **more: object) -> list[str]:
    start = text.index(part)
    found = Diagnostic("E999", "example", Span(start, start + len(part)), "found", **more)  # type: ignore[arg-type]
    return render(found, Source("f.mech", text)).splitlines()


@pytest.mark.parametrize(
    ("line", "under"),
    [
        ("link AB", "AB"),
        ("\tlink\tAB", "AB"),
        ("# 機構 AB", "AB"),
        ("param é = AB", "AB"),
        ("x" * 500 + " AB " + "y" * 500, "AB"),
        ("x" * 500 + " AB", "AB"),
    ],
)
def test_caret_is_under_the_place(line: str, under: str) -> None:
    _, quoted, carets = shown(f"pivot O\n{line}\n", under)
    assert carets.endswith("^" * len(under))
    wide = len(re.findall("[機構]", quoted))
    start = carets.index("^") - wide
    assert quoted[start : start + len(under)] == under


def test_long_line_is_cut() -> None:
    text, _, width = cut("x" * 10_000, 5_000, 9_000)
    assert len(text) <= LONGEST_EXCERPT + 2
    assert width <= LONGEST_EXCERPT
    assert text.startswith("…")
    assert text.endswith("…")


def test_control_characters_do_not_reach_the_terminal() -> None:
    assert "\x1b" not in "".join(shown("link \x1b[31mAB", "AB"))


def test_place_at_the_end_of_the_text() -> None:
    source = Source("f.mech", "link")
    last = Diagnostic("E999", "example", Span(4, 4), "more expected")
    assert render(last, source).splitlines()[-1] == "    |     ^"


def test_related_place_and_hint() -> None:
    text = "param a = 1 mm\nparam a = 2 mm\n"
    lines = shown(text, "2 mm", hint="rename one", related=(Related(Span(6, 7), "the first"),))
    assert lines[0] == "f.mech:2:11: error[E999]: found"
    assert "  f.mech:1:7: the first" in lines
    assert lines[-1] == "  hint: rename one"


def test_concise_is_one_line_and_colour_only_on_demand() -> None:
    source = Source("f.mech", "link AB")
    warning = Diagnostic("W999", "example", Span(5, 7), "m", "h")
    assert render(warning, source, "concise") == "f.mech:1:6: warning[W999]: m"
    assert "\x1b[" in render(warning, source, "concise", color=True)


def test_json_carries_all() -> None:
    source = Source("f.mech", "pivot O\nlink AB")
    error = Diagnostic("E999", "example", Span(13, 15), "m", "h", (Related(Span(0, 5), "r"),))
    record = json.loads(render(error, source, "json"))
    assert record == {
        "code": "E999",
        "name": "example",
        "severity": "error",
        "message": "m",
        "help": "h",
        "file": "f.mech",
        "start": {"line": 2, "column": 6},
        "end": {"line": 2, "column": 8},
        "related": [
            {
                "message": "r",
                "file": "f.mech",
                "start": {"line": 1, "column": 1},
                "end": {"line": 1, "column": 6},
            }
        ],
    }
