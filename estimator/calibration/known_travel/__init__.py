"""Presses of known travel against the model: registration, agreement beside nulls, bound, places read."""
