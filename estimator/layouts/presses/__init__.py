"""Presses of one face at the lowest fidelity level: compressed and mixed round magnets."""
