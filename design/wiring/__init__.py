"""Sensors on the buses of a board, and every wire between them."""
