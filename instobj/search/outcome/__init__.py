"""Outcome of a layout search: files, figures, page."""
