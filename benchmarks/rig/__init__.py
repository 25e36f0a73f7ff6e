"""What a bring-up and a rig's presses tell of hidden objects: errors and false alarms, not speed."""
