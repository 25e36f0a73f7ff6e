"""What is wrong with a recording, found from its data: each check gives what it names, and sentences."""
