"""The forward model that is inverted: tables of presses, their fields and their noise."""
