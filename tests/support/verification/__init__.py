"""Proofs of the mechanics, each with a planted fault."""
