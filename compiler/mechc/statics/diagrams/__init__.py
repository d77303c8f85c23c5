"""Free-body diagrams: every body cut free, with all that acts on it, for each set of loads.

``load_cases`` are these sets, ``cut_free`` reads the bodies off a solution of the equations;
``diagram`` is the data that reports and pictures show.
"""
