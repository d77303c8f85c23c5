"""Reports as plain text for the terminal."""
