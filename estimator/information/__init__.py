"""Information in the signals: sensitivity, Fisher information, bounds."""
