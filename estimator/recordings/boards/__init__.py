"""Readings of a board, live."""
