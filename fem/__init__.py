"""How the object deforms under presses."""
