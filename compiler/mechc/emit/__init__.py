"""Targets: Python, C, LaTeX, JSON; each one object, found by name."""
