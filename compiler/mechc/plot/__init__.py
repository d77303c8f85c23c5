"""Results against a parameter: curves, where they are broken, and the table of the same values.

A value of this folder is in SI and radians throughout. What is on a curve is a value of the
program that targets emit, on a finer and finer grid; where it is infinite, jumps or has no
value, the curve is broken, and nothing leads across.
"""
