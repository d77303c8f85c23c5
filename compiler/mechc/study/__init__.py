"""What follows from the results: zeros and poles, trends, locking, efficiency, the stroke.

Promises: what is said without "sampled" is proved; nothing here changes a formula.
"""
