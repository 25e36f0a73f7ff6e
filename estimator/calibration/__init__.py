"""The model against a built object: validation, digital twin, pretraining."""
