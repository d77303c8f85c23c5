"""Python: one module that needs only NumPy."""
