"""Contact of an indenter with a surface of known compliance."""
