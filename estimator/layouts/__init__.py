"""Many layouts scored at once, with gradients."""
