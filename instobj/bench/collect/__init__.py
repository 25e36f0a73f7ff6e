"""Boards read into recordings that grow, with their labels."""
