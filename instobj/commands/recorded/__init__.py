"""Commands that hold a model against recordings: how true it is."""
