"""Presses of one face at the lowest fidelity level: compressed, mixed round magnets, and what they change."""
