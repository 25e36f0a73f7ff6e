"""Presses of a whole object: tables of forces and magnet motions."""
