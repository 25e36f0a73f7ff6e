"""Signals of the Hall sensors at rest and under presses."""
