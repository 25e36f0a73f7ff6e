"""Layout search."""
