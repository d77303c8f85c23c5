"""pgfplots: plots for LaTeX."""
