"""The YAML notation: the table of its sections for reader, printer and schema, and its readers.

Promises: every value keeps its place in the text; a key is read, or was reported.
"""

from typing import TYPE_CHECKING

if not TYPE_CHECKING:
    from ...base.later import waiting

    SELDOM = {"slips"}
    __getattr__ = waiting(__name__, SELDOM)
