"""Presses of known travel against the model: registration, agreement against nulls, freed assumptions."""
