"""Tetrahedra of the sealed body, and their quality."""
