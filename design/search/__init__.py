"""Variables of a layout search, and the specification of a vector."""
