"""Presses of known travel against the model: registration, and agreement against nulls."""
