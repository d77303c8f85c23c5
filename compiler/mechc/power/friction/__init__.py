"""Friction inside the balance of power: what rubs, what presses, and k with it."""
