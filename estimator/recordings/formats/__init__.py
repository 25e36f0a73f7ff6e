"""File formats of recordings, read into columns."""
