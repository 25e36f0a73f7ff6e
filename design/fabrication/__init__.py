"""Checks that the parts can be printed, cast and assembled."""
