"""The helper functions of a source: those alone that it calls, as unused ones are remarked upon."""

from ...patterns import pattern

_CALL = pattern(r"\bmechc_(\w+)\(")
_NEEDS = {
    "sin": "sine",
    "cos": "sine",
    "sin_of_pair": "circular",
    "cos_of_pair": "circular",
    "tan": "circular",
}
BITS = frozenset({"sine", "circular", "nan", "if_less", "if_no_more"})
"""Those that look at the bits of numbers, for which they need ``stdint.h`` and ``string.h``."""


def helpers(code: str) -> set[str]:
    """Return the helper functions that code calls, and those that these call.

    Only helpers have names that begin with ``mechc_``: nothing else is given such a name.

    >>> sorted(helpers("return mechc_sin(x)*y;"))
    ['sin', 'sine']
    """
    called = set(_CALL.findall(code))
    return called | {_NEEDS[name] for name in called if name in _NEEDS}
