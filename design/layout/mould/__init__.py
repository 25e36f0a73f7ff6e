"""Where the parts of a mould lie, as numbers: frame, seam, pins and pouring holes."""
