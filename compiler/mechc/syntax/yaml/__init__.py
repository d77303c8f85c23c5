"""The YAML notation: its layout, one table for reader, printer and schema, and its readers.

Promises: every value keeps its place in the text; a key is read, or was reported.
"""
