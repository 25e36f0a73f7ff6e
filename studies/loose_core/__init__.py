"""A shell pushed onto its core, not bonded: unilateral contact with Coulomb friction."""
