"""A calculation sheet in numbers: its formulas as results, and what its conditions came to.

A sheet has no links, so that nothing moves in it: its results are the formulas that it gives.
They are results like those of a mechanism; code, reports and expectations take them the same
way. Promises: every condition that has a value holds at the values of the sheet, and every
result that can be computed there has a value.
"""
