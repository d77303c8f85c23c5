"""Plots on paper: axes with ticks, panels of curves, marks where these turn or are zero."""
