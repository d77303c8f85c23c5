"""The words of derivations and reports: one folder per language, plain data.

Every language is a :class:`~mechc.report.languages.locale.Locale`, so that a missing entry is a
type error. Placeholders in braces are filled by :meth:`str.format`; names of the drawing and
symbols come ready, so sentences are built not to inflect them.
"""
