"""Where things lie in the tree."""

from pathlib import Path

TESTS = Path(__file__).parents[1]
ROOT = TESTS.parent
COMPILER = ROOT / "compiler"
PACKAGE = COMPILER / "mechc"
EXAMPLES = ROOT / "examples"
LIBRARY = ROOT / "library"
CORPUS = TESTS / "corpus"
GOLDEN = TESTS / "golden"
SEEDS = TESTS / "seeds"
