"""Virtual power: Σ F·V = 0, solved for what was asked, and what follows from it."""
