"""Equilibrium of every free body: the second opinion on k. Imports nothing of kinematics or power."""
