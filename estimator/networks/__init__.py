"""The contact estimator: networks and trees, training, intervals (torch)."""
