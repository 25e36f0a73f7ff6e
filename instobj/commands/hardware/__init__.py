"""Commands that meet boards, recordings and built objects."""
