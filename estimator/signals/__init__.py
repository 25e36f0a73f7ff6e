"""What the Hall sensors read at rest and under presses."""
