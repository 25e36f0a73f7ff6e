"""The contact estimator: networks, training, metrics (torch)."""
