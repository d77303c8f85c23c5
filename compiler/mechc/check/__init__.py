"""What a book or a colleague says of a result, against what was found.

Promises: every ``expect`` has one finding, and a refutation names the pose and both numbers.
"""
