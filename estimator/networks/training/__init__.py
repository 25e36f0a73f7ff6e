"""Training of networks: data, losses, fitting."""
