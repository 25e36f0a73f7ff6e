"""The application that chains design, fem and estimator."""
