"""Studies: the tables and figures of the paper, and questions answered once."""
