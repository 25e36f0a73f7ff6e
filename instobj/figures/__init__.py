"""Figures of results (matplotlib)."""
