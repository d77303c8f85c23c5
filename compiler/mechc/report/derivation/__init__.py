"""The derivation in steps, read off the plan: what the report and the terminal print."""
