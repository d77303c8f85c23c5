"""Results for many poses by emitted code that is loaded at once: C, or NumPy without a compiler."""

from collections.abc import Mapping
from typing import Any

from ..routine.evaluate import OnArrays
from .c.library import functions
from .c.reserved import LINKED
from .c.to_c import TARGET as C
from .c.to_c import linked_names
from .names import TargetNames
from .python.printer import RESERVED
from .python.to_python import TARGET as PYTHON
from .python.to_python import function_names
from .target import Compiled, Options


def on_arrays(compiled: Compiled) -> Mapping[str, OnArrays]:
    """Return a function for each result, of its inputs in their order."""
    return _by_c(compiled) or _by_numpy(compiled)


def _by_c(compiled: Compiled) -> dict[str, OnArrays] | None:
    (source,) = C.emit(compiled, Options("code", single=True))
    linked = linked_names(compiled.routine, TargetNames(LINKED))
    return functions(
        source.text, {f.name: linked[f.name].batch for f in compiled.routine.functions}
    )


def _by_numpy(compiled: Compiled) -> dict[str, OnArrays]:
    (module,) = PYTHON.emit(compiled, Options("code", named=False))
    space: dict[str, Any] = {"__name__": compiled.routine.name}
    exec(compile(module.text, module.name, "exec"), space)
    names = function_names(compiled.routine, TargetNames(RESERVED))
    return {f.name: space[names[f.name]] for f in compiled.routine.functions}
