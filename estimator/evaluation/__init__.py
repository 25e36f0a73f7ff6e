"""How good an estimator is, beside what is possible at best."""
