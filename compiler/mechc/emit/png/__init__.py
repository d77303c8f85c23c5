"""Pictures in PNG."""
