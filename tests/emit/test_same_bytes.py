"""What mechc writes depends on no seed of hashes and no version of NumPy: the same bytes always."""

import os
import subprocess
import sys

import pytest

from good_mechanisms import GOOD, OF_LIBRARY
from paths import COMPILER, CORPUS, TESTS

SCRIPT = TESTS / "support" / "printed_digests.py"
BAD = sorted((CORPUS / "bad").glob("E*"))
TELLING = [
    *(p for p in OF_LIBRARY if p.stem in {"scissor_table", "bolt_cutter", "steering_trapezium"}),
    *(p for p in GOOD if p.stem == "class_four_block"),
]
"""Sets stood behind the order of factors, of definitions, of values in these."""


def lines(commands: str, names: list[str], seed: int) -> list[str]:
    path = os.pathsep.join((str(COMPILER), str(TESTS / "support")))
    done = subprocess.run(
        [sys.executable, str(SCRIPT), commands, *names],
        env={**os.environ, "PYTHONHASHSEED": str(seed), "PYTHONPATH": path, "COLUMNS": "80"},
        capture_output=True,
        text=True,
        check=True,
    )
    return done.stdout.splitlines()


def assert_the_same(commands: str, names: list[str], seeds: range) -> None:
    first, *others = (lines(commands, names, seed) for seed in seeds)
    assert first.pop() == "no NumPy"
    assert len(first) == len(names) * len(commands.split(","))
    for other in others:
        assert other[:-1] == first


def test_the_bytes_are_the_same_for_every_seed():
    assert_the_same("json", [*map(str, TELLING)], range(2))


COMMANDS = "check,derive,stroke,show pose,show statics,show figure,show bodies"
EVERYTHING = f"{COMMANDS},latex,python,c,json"


@pytest.mark.slow
@pytest.mark.parametrize("part", range(0, 24, 8))
def test_much_of_library_and_corpus_is_the_same_for_every_seed(part):
    names = [str(path) for path in (*OF_LIBRARY, *GOOD, *BAD)[part::24]]
    assert_the_same(EVERYTHING, names, range(part, part + 2))


@pytest.mark.slow
@pytest.mark.parametrize("part", range(3))
def test_grown_mechanisms_are_the_same_for_every_seed(part):
    names = [f"grown:{seed}" for seed in range(2 * part, 2 * part + 2)]
    assert_the_same(EVERYTHING, names, range(part, part + 2))
