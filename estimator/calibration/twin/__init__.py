"""Digital twins: models calibrated on presses of one built object."""
