"""Grasps in recordings, measured and ranked (`instobj assess`)."""
