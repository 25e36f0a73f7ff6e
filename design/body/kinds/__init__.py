"""Kinds of body: one class in one file, collected by `registry`."""
