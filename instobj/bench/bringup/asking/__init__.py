"""What a bring-up asks a person to do: recordings, and places where the magnet is held."""
