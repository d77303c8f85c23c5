"""LaTeX: a report that compiles by itself, or a fragment of it, in three languages."""
