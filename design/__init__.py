"""What the object is: its specification, shape, layout, solids and files."""
