"""Print the commands that README.md gives for a fresh machine, one a line, as they stand."""

import re
import sys
from pathlib import Path


def commands(readme: str) -> list[str]:
    """Return the lines of the shell blocks in the section "Two commands"."""
    section = re.search(r"^## Two commands\n(.*?)^## ", readme, re.DOTALL | re.MULTILINE)
    assert section, "README.md has no section 'Two commands'"
    blocks = re.findall(r"^```sh\n(.*?)^```", section[1], re.DOTALL | re.MULTILINE)
    return [line for block in blocks for line in block.splitlines() if line]


if __name__ == "__main__":
    print("\n".join(commands(Path(sys.argv[1]).read_text(encoding="utf-8"))))
