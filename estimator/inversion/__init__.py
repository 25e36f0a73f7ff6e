"""Inversion of the forward model: contacts of the whole object, at maximum a posteriori."""
