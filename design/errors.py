"""The one error that users see: what was wrong, what was received and how to mend it."""


class InputError(ValueError):
    """Bad input from the user; the command line prints its message alone and exits with 2."""
