"""Presses of known travel against the model: registration, agreement beside nulls, freed assumptions."""
