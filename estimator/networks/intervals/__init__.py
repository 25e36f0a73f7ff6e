"""Intervals and coverage of predictions, from held-out presses."""
