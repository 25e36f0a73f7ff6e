"""Exploring by hand: a page on which parts are moved and the map of bounds follows."""
