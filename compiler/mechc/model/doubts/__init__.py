"""What can be meant, and hardly ever is: remarks on a description that is understood.

Promises: warnings only; what follows is the same with and without them.
"""
