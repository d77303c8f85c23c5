"""Sentences of a report: remarks, rules of the derivation, locking; in any language."""
