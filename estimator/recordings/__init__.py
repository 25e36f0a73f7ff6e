"""Recordings of real objects, read into frames."""
