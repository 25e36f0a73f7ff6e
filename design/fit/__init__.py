"""Fit of everything that a specification asks for."""
