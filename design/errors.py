"""The family of errors: what was wrong, what was received and how to fix it."""

from pathlib import Path
from typing import Any


class InstobjError(Exception):
    """Whatever instobj raises on purpose; the command line prints its message and exits with 2."""


class InputError(InstobjError, ValueError):
    """Bad input from the user: a value out of range, a wrong file, an impossible request."""


class SpecError(InputError):
    """A specification that cannot be read, or an object that does not fit together."""


class RecordingError(InputError):
    """A recording, or a file that describes one, that cannot be read or contradicts itself."""


class StoreError(InstobjError, OSError):
    """A result file that cannot be written, cannot be read back, or is damaged."""


class FullDisk(StoreError):
    """A file that does not fit on its disk; `path` is the file, `reason` what the system said."""

    def __init__(self, message: str, path: Path, reason: str) -> None:
        super().__init__(message)
        self.path, self.reason = path, reason


class SolverError(InstobjError, ArithmeticError):
    """A computation on good input that failed: no convergence, or a singular system."""


class NotOneSolid(InputError):
    """A part that came out in pieces or invalid; `shape`, a solid or triangles, is what was made."""

    def __init__(self, message: str, shape: Any) -> None:
        super().__init__(message)
        self.shape = shape


DAMAGED_CONTENT = (
    ArithmeticError,
    AttributeError,
    LookupError,
    RuntimeError,
    TypeError,
    ValueError,
)
"""Errors that building an object from a file's content raises where the content is not what instobj wrote."""
