"""Firmware projects that read an object's sensors, and their wiring."""
