"""Keys by content: SHA-256 of JSON-able content, of a file, and of what a stage is made from."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path
from typing import Any

_FORMAT = 3
"""Raised when results of earlier versions can no longer be used (3: all keys of a part are inputs)."""


def content_key(content: Any) -> str:
    """SHA-256 of JSON-able content, independent of the order of keys."""
    return hashlib.sha256(json.dumps(content, sort_keys=True).encode()).hexdigest()


def file_key(path: Path) -> str:
    """SHA-256 of a file's bytes, read in blocks."""
    with path.open("rb") as stream:
        return hashlib.file_digest(stream, "sha256").hexdigest()


def stage_key(stage: str, inputs: dict[str, Any]) -> str:
    """Key of a stage's result: of its name and of everything that the result depends on."""
    return content_key({"format": _FORMAT, "stage": stage, "inputs": inputs})
