"""Moulds that the shell is cast in (CadQuery)."""
