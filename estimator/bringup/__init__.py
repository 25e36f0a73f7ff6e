"""What the chips, magnets and levels of a newly soldered object are, from its own readings."""
