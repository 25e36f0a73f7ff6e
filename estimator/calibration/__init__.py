"""Models against built objects: validation, digital twin."""
