"""The errors that users see: what was wrong, what was received and how to mend it."""

from typing import Any


class InputError(ValueError):
    """Bad input from the user; the command line prints its message alone and exits with 2."""


class NotOneSolid(InputError):
    """A part that came out in pieces or invalid; `shape`, a solid or triangles, is what was made."""

    def __init__(self, message: str, shape: Any) -> None:
        super().__init__(message)
        self.shape = shape
