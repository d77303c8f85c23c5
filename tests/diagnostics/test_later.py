"""The words of errors are imported when the first of them is needed."""

import subprocess
import sys
from pkgutil import iter_modules

import pytest

from mechc import diagnostics
from mechc.diagnostics import model

OTHERS = {"diagnostic", "model", "render"}


@pytest.mark.parametrize("package", [diagnostics, model])
def test_every_module_of_words_may_wait(package):
    assert {m.name for m in iter_modules(package.__path__)} - OTHERS == package.WORDS
    with pytest.raises(AttributeError, match="nonsense"):
        _ = package.nonsense


def test_a_module_that_waits_is_imported_with_its_first_word():
    code = (
        "import sys\n"
        "from mechc.diagnostics import stroke as messages\n"
        "assert 'mechc.diagnostics.stroke' not in sys.modules\n"
        "assert callable(messages.Message)\n"
        "assert sys.modules['mechc.diagnostics.stroke'].Message is messages.Message\n"
        "try: messages.nonsense\n"
        "except AttributeError: pass\n"
        "else: raise AssertionError\n"
    )
    subprocess.run([sys.executable, "-c", code], check=True)
