"""What stands for a module that waits is the module, for whoever reads or sets a name of it."""

import sys
from types import ModuleType

import pytest

from mechc.base.later import Later, waiting


@pytest.fixture
def module(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    made = ModuleType("made_up")
    made.number = 1  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, "made_up", made)
    return made


def test_names_are_those_of_the_module(module: ModuleType) -> None:
    assert Later("made_up").number == 1
    with pytest.raises(AttributeError):
        Later("made_up").letter  # noqa: B018


def test_what_is_set_is_set_in_the_module(module: ModuleType) -> None:
    later = Later("made_up")
    later.number = 2
    assert (later.number, vars(module)["number"]) == (2, 2)
    del later.number
    assert "number" not in vars(module)


def test_a_package_gives_its_waiting_modules_and_no_others() -> None:
    attribute = waiting("mechc", {"version"})
    assert attribute("version").__name__ == "mechc.version"
    with pytest.raises(AttributeError, match="module 'mechc' has no attribute 'else'"):
        attribute("else")
