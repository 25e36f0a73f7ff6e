"""Recordings made for tests, and boards without hardware."""
