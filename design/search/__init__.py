"""What a layout search may change, and how a vector becomes a specification."""
