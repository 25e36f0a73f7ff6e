"""Places of contacts, magnets and sensors."""
