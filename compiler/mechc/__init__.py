"""mechc compiles a description of a planar mechanism into its force transmission.

>>> import mechc
>>> clamp = mechc.load("karpenko_fig9_packet_clamp")   # a file, or a name of the library
>>> clamp.k
a*sin(alpha + beta)/(2*b*cos(alpha)*cos(beta))

Quantities are SI and radians. Importing the package is cheap: the compiler is imported
with the first :func:`load`, sympy with the first expression, NumPy with the first number.
"""

from __future__ import annotations

from importlib import import_module

from .version import VERSION

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from .api import SolvedMechanism, load, loads
    from .diagnostics import MechcError

__version__ = VERSION

__all__ = ["MechcError", "SolvedMechanism", "__version__", "load", "loads"]

_PLACES = {"SolvedMechanism": "api", "load": "api", "loads": "api", "MechcError": "diagnostics"}


def __getattr__(name: str) -> Any:
    if name not in _PLACES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f".{_PLACES[name]}", __name__), name)
