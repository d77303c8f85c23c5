"""The drawing: lines, arcs and labels on paper, in the symbols of kinematic schemes (ISO 3952).

Whoever writes a file of pictures needs nothing but the drawing: no symbol, no mechanism. No
two labels touch, and none lies on a line.
"""
