"""The language-neutral straight-line program and its interpreter, the oracle of every target."""
