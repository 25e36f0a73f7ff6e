"""Pages and texts, made from results alone."""
