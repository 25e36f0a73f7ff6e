"""Sweeps: many specifications through the chain, on one machine or on many."""
