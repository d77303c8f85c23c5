"""Names in the other half of a mirrored mechanism: the twin of ``B`` is ``B'``.

A description names twins so as well; no other module knows what their names look like.
"""

PRIME = "'"


def primed(name: str) -> str:
    """Return the name of a twin.

    >>> primed("B")
    "B'"
    """
    return name + PRIME


def is_primed(name: str) -> bool:
    """Return whether a name is that of a twin."""
    return name.endswith(PRIME)


def without_prime(name: str) -> str:
    """Return the name of what is described, whether its twin is named or itself.

    >>> without_prime("B'"), without_prime("B")
    ('B', 'B')
    """
    return name.removesuffix(PRIME)
