"""Signals of presses, and estimators that read contacts back from them."""
