"""The LaTeX target: a report that compiles by itself, or a fragment of it."""
