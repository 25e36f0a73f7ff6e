"""Findings of one kind of recording each: chips, gains, levels, poles, and what is out of order."""
