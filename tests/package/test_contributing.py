"""CONTRIBUTING names places that are there: its tables and lists are the map of the tree."""

import re

import pytest

from paths import PACKAGE, ROOT, TESTS

TEXT = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
PLACES = sorted(set(re.findall(r"`([\w.*]+/[\w./*]*|\w+\.py)`", TEXT)))
MADE_UP = ("NAME", "CODE")
"""What stands for a name of the reader's own."""


@pytest.mark.parametrize("place", [p for p in PLACES if not any(n in p for n in MADE_UP)])
def test_places_exist(place: str) -> None:
    """From the root or below the package; one without a folder anywhere in the code."""
    near = (ROOT.glob(place), PACKAGE.glob(place))
    anywhere = () if "/" in place.rstrip("/") else (PACKAGE.rglob(place), TESTS.rglob(place))
    assert any(path for paths in (*near, *anywhere) for path in paths)
