"""Maps of a score over the contact locations."""
