"""Which directions are given and which follow; loops closed.

Promises: every pair of points of a link has a vector, every guide and force a
direction; no symbol of the result is undefined; given data do not contradict.
"""
