"""A newly soldered object brought up: what its recordings tell together, and which to ask for next."""
