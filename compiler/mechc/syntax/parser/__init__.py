"""The grammar read by tables: lines to tokens, tokens to nodes, and the words for what is wrong.

Promises: a statement is a node with the span of its text, or it was reported, with one hint.
"""

from typing import TYPE_CHECKING

if not TYPE_CHECKING:
    from ...base.later import waiting

    SELDOM = {"slips", "statement_examples", "unit_words", "usual_slips"}
    __getattr__ = waiting(__name__, SELDOM)
