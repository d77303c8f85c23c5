"""What docstrings refer to by a path is there."""

import re
from collections.abc import Iterator
from importlib import import_module, util

import pytest

from paths import PACKAGE

REFERENCE = re.compile(r":(?:mod|class|data|func|attr|meth):`~?((?:\.+|mechc\.)[\w.]+)`")


def references() -> Iterator[tuple[str, str]]:
    """Yield each module with the whole path of a thing that a docstring of it refers to."""
    for path in sorted(PACKAGE.rglob("*.py")):
        folder = ["mechc", *path.relative_to(PACKAGE).parts[:-1]]
        for target in REFERENCE.findall(path.read_text("utf-8")):
            up = len(target) - len(target.lstrip("."))
            base = folder[: len(folder) + 1 - up] if up else []
            yield path.relative_to(PACKAGE).as_posix(), ".".join([*base, target.lstrip(".")])


def is_there(path: str) -> bool:
    """Return whether a path leads to a module, or to a name in one."""
    parts, found = path.split("."), 1
    while found < len(parts) and util.find_spec(".".join(parts[: found + 1])):
        found += 1
        if not (PACKAGE.joinpath(*parts[1:found])).is_dir():
            break
    thing: object = import_module(".".join(parts[:found]))
    for name in parts[found:]:
        if name in getattr(thing, "__annotations__", {}):
            return True
        if not hasattr(thing, name):
            return False
        thing = getattr(thing, name)
    return True


@pytest.mark.parametrize(("module", "path"), sorted(set(references())))
def test_what_is_referred_to_is_there(module: str, path: str) -> None:
    assert is_there(path), module
