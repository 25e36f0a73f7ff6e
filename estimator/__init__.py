"""What the sensors see and what can be read back from them."""
