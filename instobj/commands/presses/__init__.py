"""Commands that press chosen places of one object."""
