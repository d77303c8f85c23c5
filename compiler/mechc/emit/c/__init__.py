"""C99: a header and a source, one function and one loop for each result."""
