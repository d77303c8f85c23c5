"""JSON: the whole result for machines, and the schema that says what it means."""
