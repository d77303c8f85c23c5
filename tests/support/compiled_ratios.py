"""Results and their statuses on arrays: of what is iterated from emitted C, which is far faster.

That C gives what the interpreter does is looked at elsewhere, at random poses (``run_targets``).
"""

import ctypes
import tempfile
from collections.abc import Callable, Mapping
from functools import lru_cache
from pathlib import Path
from types import SimpleNamespace

import numpy as np

from mechc.compilation import Compilation
from mechc.routine.evaluate import evaluate, status
from mechc.routine.steps import Function, Solve
from run_targets import COMPILER, built

Array = np.ndarray
Values = Mapping[str, float | Array]


class Ratio:
    """A result with friction, or without it, on arrays of places."""

    def __init__(self, compilation: Compilation, name: str) -> None:
        self.function = next(f for f in compilation.routine.functions if f.name == name)
        is_iterated = any(isinstance(step, Solve) for step in self.function.steps)
        self._code = in_c(compilation) if is_iterated else None

    def values(self, values: Values) -> Array:
        """Return the result where the values, which broadcast together, are its inputs'."""
        if self._code is None:
            return np.asarray(evaluate(self.function, values))
        inputs = [i.name for i in self.function.inputs]
        return self._code(f"{self.function.name}_n", inputs, np.float64, values)

    def states(self, ideal: Function, values: Values) -> Array:
        """Return the statuses; ``ideal`` is the same result without friction."""
        if self._code is None:
            return np.asarray(status(self.function, ideal, values))
        asked = self.function.status
        assert asked is not None
        inputs = [i.name for i in asked.inputs]
        return self._code(f"{self.function.name}_status_n", inputs, np.intc, values)


Code = Callable[[str, list[str], type, Values], Array]
"""A function of the library by its name, inputs and the type of its output, on values."""


@lru_cache(maxsize=1)
def library(compilation: Compilation) -> SimpleNamespace:
    """Return the compiled library of a compilation, built once."""
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        return built(compilation, Path(folder))  # it stays open when its file goes


def in_c(compilation: Compilation) -> Code | None:
    """Return a function that calls those of the compiled library; None without a compiler."""
    if not COMPILER:
        return None
    code = library(compilation).code

    def call(name: str, inputs: list[str], kind: type, values: Values) -> Array:
        function = code[f"{compilation.routine.name}_{name}"]
        function.restype = None
        shape = np.broadcast_shapes(*(np.shape(values[i]) for i in inputs))
        arrays = [_whole(values[i], shape) for i in inputs]
        found = np.empty(shape, dtype=kind)
        pointers = [a.ctypes.data_as(ctypes.c_void_p) for a in (*arrays, found)]
        function(ctypes.c_size_t(found.size), *pointers)
        return found

    return call


def _whole(values: float | Array, shape: tuple[int, ...]) -> Array:
    return np.ascontiguousarray(np.broadcast_to(np.asarray(values, dtype=np.float64), shape))
