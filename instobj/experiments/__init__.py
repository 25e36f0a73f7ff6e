"""Studies of layouts, and the registry of experiments."""
