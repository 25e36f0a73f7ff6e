"""Presses beyond small strain, and how far small strain holds."""
