"""Makers of the stages: from a specification and earlier results to files."""
