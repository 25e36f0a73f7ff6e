"""What the sensors see of a press, and what can be read back from it."""
