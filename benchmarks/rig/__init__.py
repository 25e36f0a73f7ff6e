"""Studies of bring-up and press rig on hidden objects: errors and false alarms, not speed."""
