"""Checksum inside a file whose format has room for a text: every other program still reads it.

The text is `SEAL`: a mark and 64 zeros, in whose place the SHA-256 of the file (with the zeros) is
written. Against accidents, not against somebody who may write the file.
"""

from __future__ import annotations

import hashlib
from pathlib import Path

from design.errors import StoreError

_MARK = b"instobj sha256 "
_DIGITS = 64
SEAL = (_MARK + b"0" * _DIGITS).decode()
"""To be written once into the file, as plain bytes."""


def seal_file(path: Path) -> None:
    """Write the checksum into a finished file that holds `SEAL` once.

    Raises
    ------
    ValueError
        `SEAL` is not there exactly once.
    """
    content = path.read_bytes()
    if content.count(SEAL.encode()) != 1:
        raise ValueError(f"{path} holds {content.count(SEAL.encode())} seals, not 1")
    digest = hashlib.sha256(content).hexdigest().encode()
    path.write_bytes(content.replace(SEAL.encode(), _MARK + digest))


def sealed_content(path: Path, advice: str) -> bytes:
    """The bytes of a file whose checksum is right.

    Raises
    ------
    StoreError
        No checksum, or another than the content's; `advice` says how to get a sound file.
    """
    content = path.read_bytes()
    start = content.find(_MARK)
    if start < 0:
        raise StoreError(
            f"{path} carries no checksum of instobj: another program wrote it, or an earlier "
            f"version. {advice}"
        )
    digits = slice(start + len(_MARK), start + len(_MARK) + _DIGITS)
    blank = content[: digits.start] + b"0" * _DIGITS + content[digits.stop :]
    if content[digits] != hashlib.sha256(blank).hexdigest().encode():
        raise StoreError(f"{path} is damaged: its checksum is not that of its content. {advice}")
    return content
