"""Whether everything that a specification asks for fits."""
