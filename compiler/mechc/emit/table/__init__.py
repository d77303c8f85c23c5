"""Tables of the values of a plot."""
