"""How large a description may be. Beyond, reading it could take seconds or all memory."""

CHARACTERS = 250_000
"""Length of the text: some 8,000 statements."""

NESTING = 64
"""Depth of brackets, powers of powers and repeated signs in one expression."""

MOST_DIGITS = 40
"""Digits of a number."""

DECIMAL_EXPONENT = 308
"""Of ``1e308``: what a double can hold."""

POWER = 64
"""A whole number written as an exponent."""

YAML_DEPTH = 32
YAML_NODES = 20_000

FAULTS = 50
"""Errors of syntax reported in one run."""
