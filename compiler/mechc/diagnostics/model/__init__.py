"""The words of errors in what a description means (E2xx), a module for each subject."""

from typing import TYPE_CHECKING

if not TYPE_CHECKING:
    from ...later import Later

    WORDS = {
        *("doubts", "friction", "held", "joints", "loads", "lowering", "names", "quantities"),
        *("reactions", "reported", "results", "sheets", "symmetry", "translations", "wheels"),
    }

    def __getattr__(name: str) -> Later:
        if name not in WORDS:
            raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
        return Later(f"{__name__}.{name}")
