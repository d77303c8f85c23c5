"""The words of errors in what a description means (E2xx), a module for each subject."""

from . import joints, loads, names, quantities, results

__all__ = ["joints", "loads", "names", "quantities", "results"]
