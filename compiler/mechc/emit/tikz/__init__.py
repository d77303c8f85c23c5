"""Pictures in TikZ."""
