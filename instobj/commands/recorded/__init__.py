"""Commands that hold a model against recordings: how true it is, and what the residuals point to."""
