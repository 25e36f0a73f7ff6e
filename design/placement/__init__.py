"""Placement of everything on a body of a given kind and size, so that it fits and can be made."""
