"""Object to build: its specification, shape, layout, solids and files."""
