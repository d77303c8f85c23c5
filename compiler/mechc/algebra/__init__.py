"""Angle algebra, and the formulas that are handed out.

``angle``: integer combinations of symbols plus a constant. ``product``: factored
products of lengths, sines, cosines and sums. ``laurent``: canonical sums.
``formula``: the expression tree that printers, sympy and the routine read.
"""
