"""Sentences of a report: remarks, rules of the derivation, locking; in any language."""

from typing import TYPE_CHECKING

if not TYPE_CHECKING:
    from ...base.later import waiting

    SELDOM = {"extents"}
    __getattr__ = waiting(__name__, SELDOM)
