"""Deformation of the object under presses."""
