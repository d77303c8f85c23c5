"""Results against a parameter: curves, where they are broken, and the table of the same values.

A value of this folder is in SI and radians throughout. What is on a curve is a value of the
program that targets emit, on finer and finer places; where it is infinite, jumps or has no
value, the curve is broken, and nothing leads across.
"""
