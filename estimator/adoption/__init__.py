"""Logs of objects that others built: read, identified from the data, and made a specification."""
