"""Places of the parts of a mould, as numbers: frame, seam, pins and pouring holes."""
