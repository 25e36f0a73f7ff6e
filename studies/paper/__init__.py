"""The experiments of Knopke et al."""
