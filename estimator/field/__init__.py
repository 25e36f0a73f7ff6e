"""Flux density of magnets, and its derivatives."""
