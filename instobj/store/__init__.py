"""Stored results: keys, the contract of a stage, publishing."""
