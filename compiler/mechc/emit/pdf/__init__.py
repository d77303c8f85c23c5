"""PDF: pictures."""
