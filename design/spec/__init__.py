"""What the user wrote: the specification and its parts, as frozen models."""
