"""Planted faults: which share of small random changes of the code the usual tests notice."""
