"""Limits that a batch of layouts breaks, as distances with gradients."""
