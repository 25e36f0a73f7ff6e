"""Meshes, responses and closed forms of mechanics."""
