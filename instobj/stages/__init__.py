"""The stages of the chain, and what runs them."""
