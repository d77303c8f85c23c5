"""Signs of slips and forces, on which every closed form with friction depends.

``senses`` says which way a value goes, and whether it goes at all. ``names`` has what both ways
to write signs down have in common: ``at_any_pose`` as names that code computes, ``at_one_pose`` as
the numbers of the default pose, and ``conditions`` says while which conditions these stay so.
"""
