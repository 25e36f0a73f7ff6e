"""Objects that several tests share."""
