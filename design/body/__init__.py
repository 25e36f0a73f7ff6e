"""What shape the body has, as numbers and triangles (no CAD kernel)."""
