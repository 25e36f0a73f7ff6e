"""Small-strain elasticity: one factorization that answers every load."""
