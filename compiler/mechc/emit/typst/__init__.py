"""Pictures as PDF and PNG, by a library that brings its own letters."""
