"""Angle algebra, and the formulas that are handed out.

``angle``: rational combinations of symbols plus a constant. ``factors``, ``product``,
``trigonometry``: factored products of lengths, sines, cosines and sums. ``sums``: their
canonical sums, by way of ``laurent``, ``factoring`` and ``reduction``. ``formula``: the
expression tree that printers, sympy and the routine read.
"""
