"""Names in the other half of a mirrored mechanism: the twin of ``B`` is ``B'``.

A description names twins so as well. Only where names are read is a twin known by its name;
everywhere else it is a field that states so.
"""

PRIME = "'"


def primed(name: str) -> str:
    """Return the name of a twin.

    >>> primed("B")
    "B'"
    """
    return name + PRIME


def without_prime(name: str) -> str:
    """Return the name of what is described, whether its twin is named or itself.

    >>> without_prime("B'"), without_prime("B")
    ('B', 'B')
    """
    return name.removesuffix(PRIME)
