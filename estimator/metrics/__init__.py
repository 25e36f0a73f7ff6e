"""Distance of what an estimator reads from what is true."""
