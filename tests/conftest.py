"""What the whole suite shares: goldens with ``--update``, and no text that runs."""

import gc
import os
import subprocess
import sys
from collections.abc import Callable
from difflib import unified_diff
from typing import NoReturn

import pytest
from hypothesis import settings

from paths import COMPILER, GOLDEN

# The same examples in each run: what lands was seen to pass.
settings.register_profile("fixed", derandomize=True, deadline=None)
settings.load_profile("fixed")


# Searches for garbage every 700 objects are a twelfth of what a test of the compiler takes.
gc.set_threshold(50_000)


# What is tested is computed here and now.
os.environ["MECHC_CACHE"] = ""


@pytest.hookimpl(tryfirst=True)
def pytest_sessionfinish() -> None:
    """Let what is left be no garbage: pytest would look through all of it five times over."""
    gc.freeze()


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--update", action="store_true", help="accept what the goldens have become")


@pytest.fixture
def golden(request: pytest.FixtureRequest) -> Callable[[str, str], None]:
    """Compare a text with ``golden/NAME``, or write it there under ``--update``."""

    def compare(name: str, found: str) -> None:
        path = GOLDEN / name
        if request.config.getoption("--update"):
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(found, encoding="utf-8", newline="\n")
        expected = path.read_text(encoding="utf-8") if path.exists() else ""
        if found != expected:
            lines = [text.splitlines() for text in (expected, found)]
            pytest.fail("\n".join(unified_diff(*lines, "golden", "found", lineterm="")))

    return compare


@pytest.fixture
def run_shell() -> Callable[..., subprocess.CompletedProcess[str]]:
    """Return a function that runs a line of the shell, in which ``$MECHC`` is the command."""

    def call(line: str, **environment: str) -> subprocess.CompletedProcess[str]:
        own = {"MECHC": f"{sys.executable} -m mechc", "PYTHONPATH": str(COMPILER)}
        return subprocess.run(
            ["bash", "-c", line],
            capture_output=True,
            text=True,
            encoding="utf-8",
            env={**os.environ, **own, **environment},
            timeout=60,
        )

    return call


@pytest.fixture(scope="session", autouse=True)
def sympy_reads_no_text() -> None:
    """Make sympy's string parser raise: text given to it would be executed."""
    from sympy.parsing import sympy_parser

    def refuse(*_: object, **__: object) -> NoReturn:
        raise AssertionError("a string reached sympy's parser")

    sympy_parser.parse_expr = refuse
