"""What one kind of recording tells: chips, gains, levels, poles, and what is out of order."""
