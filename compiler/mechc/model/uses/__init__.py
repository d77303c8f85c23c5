"""What a sheet or a mechanism uses: statements of it, under its prefix, in place of the line.

Promises: no use is left, and every name that came in this way begins with the prefix of its use.
"""

from typing import TYPE_CHECKING

if not TYPE_CHECKING:
    from ...base.later import waiting

    SELDOM = {"composing", "mechanism_statements"}
    __getattr__ = waiting(__name__, SELDOM)
