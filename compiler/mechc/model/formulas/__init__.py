"""Expressions to formulas in SI, and the parameters and lets that are made of them.

Promises: a formula has one dimension, and definitions have no cycle.
"""
