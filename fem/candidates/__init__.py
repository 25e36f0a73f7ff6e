"""Magnets anywhere in the shell, without another mesh."""
