"""Exploring by hand: a page on which parts are moved and the map of what is told follows."""
