"""What can be known from the signals at best: sensitivity, Fisher information, bounds."""
