"""The rows of a table of mechanisms: formulas beside the scheme, others below, wide ones alone."""

import pytest

from mechc.emit.latex import comparison


@pytest.mark.parametrize(
    ("sections", "rows"),
    [
        ("", [""]),
        ("a", ["a"]),
        ("ab", ["ab"]),
        ("aW", ["a", "W"]),
        ("Wa", ["", "W", "a"]),
        ("aWb", ["a", "W", "b"]),
        ("WV", ["", "W", "V"]),
        ("aWbcV", ["a", "W", "bc", "V"]),
    ],
)
def test_a_wide_formula_has_a_row_of_its_own(sections, rows, monkeypatch):
    monkeypatch.setattr(comparison, "_BESIDE", 2)
    monkeypatch.setattr(comparison, "_is_wide", lambda section, _: section.isupper())
    assert ["".join(row) for row in comparison._in_rows(sections, None)] == rows


def test_no_row_has_more_than_stands_beside_a_scheme(monkeypatch):
    monkeypatch.setattr(comparison, "_BESIDE", 2)
    monkeypatch.setattr(comparison, "_is_wide", lambda *_: False)
    assert comparison._in_rows("abcde", None) == [["a", "b"], ["c", "d"], ["e"]]
