"""mechc compiles a description of a planar mechanism into its force transmission."""

__version__ = "0.1.0"
