"""Labelled frames: data sets, and their simulation."""
