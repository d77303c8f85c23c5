"""LaTeX engines run on what was written."""

import os
import shutil
import subprocess
from pathlib import Path

import pytest


def compile_tex(engine: str, text: str, folder: Path) -> str:
    """Run an engine that may read nothing outside the folder; return its log."""
    if shutil.which(engine) is None:
        pytest.skip(f"{engine} is not installed")
    (folder / "report.tex").write_text(text, encoding="utf-8")
    command = [engine, "-no-shell-escape", "-interaction=nonstopmode", "report.tex"]
    environment = os.environ | {"openin_any": "p", "openout_any": "p"}
    run = subprocess.run(command, cwd=folder, env=environment, capture_output=True, timeout=120)
    log = (folder / "report.log").read_text(encoding="utf-8", errors="replace")
    assert run.returncode == 0, log[-3000:]
    assert (folder / "report.pdf").stat().st_size > 5000
    return log


def needs_cyrillic() -> None:
    """Skip the test where TeX has no Cyrillic fonts."""
    if shutil.which("kpsewhich") is None:
        return
    found = subprocess.run(["kpsewhich", "t2aenc.def"], capture_output=True, check=False)
    if found.returncode:
        pytest.skip("no Cyrillic fonts for TeX")
