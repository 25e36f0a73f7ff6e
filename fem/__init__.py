"""How the object deforms: mesh, elasticity, contact and response."""
