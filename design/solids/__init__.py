"""Exact solids of core, shell, probes and jigs (CadQuery)."""
