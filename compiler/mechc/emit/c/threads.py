"""C's forms for many poses over all processors, by OpenMP (``--c-openmp``).

A form is put into parts of so many poses outside its loop: within a parallel region gcc forgets
that its arrays do not overlap, and the loop would be scalar code.
"""

import re
from collections.abc import Container

from ...base.later import pattern

PART = 4096
"""The poses of a part: a whole number of the blocks of a loop, within the cache."""

LEAST = 4 * PART
"""The poses from which on it pays to wake the other threads."""

_BATCH = pattern(r"^void (\w+)\((\s*size_t (\w+),[^)]*)\)\n\{\n.*?^\}\n?", re.M | re.S)
_LAST_NAME = pattern(r"(\w+)\s*$")


def in_threads(code: str) -> str:
    """Return C whose forms for many poses work in parts, side by side under OpenMP."""
    names = frozenset(re.findall(r"\w+", code))
    return _BATCH.sub(lambda found: _in_parts(found, names), code)


def _in_parts(found: re.Match[str], names: Container[str]) -> str:
    """Return a form for many poses as one for a part, and the form that calls it for each."""
    name, heads, number = found.group(1, 2, 3)
    _, *arrays = [_LAST_NAME.findall(head)[0] for head in heads.split(",")]
    own, part, start = (_free(n, names) for n in (f"{name}_part", "mechc_part", "mechc_start"))
    shifted = ", ".join(f"{array} + {start}" for array in arrays)
    return f"""static {found.group().replace(name, own, 1).rstrip()}

void {name}({heads})
{{
#ifdef _OPENMP
    ptrdiff_t {part};
#pragma omp parallel for schedule(static) if ({number} >= {LEAST})
    for ({part} = 0; {part} < (ptrdiff_t)(({number} + {PART - 1})/{PART}); ++{part}) {{
        const size_t {start} = (size_t){part}*{PART};
        {own}({number} - {start} < {PART} ? {number} - {start} : {PART}, {shifted});
    }}
#else
    {own}({number}, {", ".join(arrays)});
#endif
}}
"""


def _free(name: str, names: Container[str]) -> str:
    while name in names:
        name += "_"
    return name
