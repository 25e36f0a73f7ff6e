"""Which sensor sits on which bus of which board, and every wire between them."""
