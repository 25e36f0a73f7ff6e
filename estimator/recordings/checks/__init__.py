"""What is wrong with a recording, found from its data."""
