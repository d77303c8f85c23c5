"""Mathematics, quantities and tables as LaTeX."""
