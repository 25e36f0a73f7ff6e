"""Shape of the body, as numbers and triangles (no CAD kernel)."""
