"""Grasps in contacts over time: found, measured, judged against limits of damage, and ranked."""
