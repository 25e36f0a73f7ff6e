"""Checksums in files, where every other program still reads them, and which files are this user's.

`SEAL` stands inside a file whose format has room for a text: a mark and 64 zeros, in whose place the
SHA-256 of the file (with the zeros) is written. `end_seal` stands behind a file that may have bytes
there. Both are against accidents: anybody can write them. That this user's instobj wrote a file is
proven by a list of SHA-256 that this user alone can change, outside of the file.
"""

from __future__ import annotations

import hashlib
import os
from contextlib import suppress
from pathlib import Path

import numpy as np

from design.errors import StoreError

_MARK = b"instobj sha256 "
_DIGITS = 64
SEAL = (_MARK + b"0" * _DIGITS).decode()
"""To be written once into the file, as plain bytes."""
_END = b"instobj sha256: "
_END_BYTES = len(_END) + hashlib.sha256().digest_size
_OTHERS_MAY_WRITE = 0o022
"""Bits of a file's mode by which its group or all may write it."""


def sealed(content: bytes) -> bytes:
    """A finished file's bytes, which hold `SEAL` once, with the checksum in its place.

    Raises
    ------
    ValueError
        `SEAL` is not there exactly once.
    """
    if content.count(SEAL.encode()) != 1:
        raise ValueError(f"the file holds {content.count(SEAL.encode())} seals, not 1")
    digest = hashlib.sha256(content).hexdigest().encode()
    return content.replace(SEAL.encode(), _MARK + digest)


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


def end_seal(content: bytes | memoryview) -> bytes:
    """Bytes to stand behind a file: a mark and the SHA-256 of its content.

    The hash joins the list of what this user's instobj wrote. Where no list can be kept the file
    will be read as if others had written it, which takes longer.
    """
    digest = hashlib.sha256(content).digest()
    with suppress(OSError, RuntimeError):  # a home that cannot be written, or none
        path = _list_path()
        path.parent.mkdir(parents=True, exist_ok=True)
        handle = os.open(path, os.O_WRONLY | os.O_APPEND | os.O_CREAT, 0o600)
        try:
            os.write(handle, digest)  # so short a write is whole, whatever others append
        finally:
            os.close(handle)
    return _END + digest


def is_own(content: np.ndarray) -> bool:
    """Return whether this user's instobj wrote a file, by the list of what it wrote.

    Raises
    ------
    StoreError
        There is a seal behind the content, of whomever, and it is of another content.
    """
    end = content[-_END_BYTES:].tobytes()
    if not end.startswith(_END):
        return False
    digest = end[len(_END) :]
    if hashlib.sha256(content[:-_END_BYTES].data).digest() != digest:
        raise StoreError("its bytes have changed since they were written")
    with suppress(OSError, RuntimeError):
        path = _list_path()
        if os.name != "posix" or not path.stat().st_mode & _OTHERS_MAY_WRITE:
            return digest in path.read_bytes()
    return False


def _list_path() -> Path:
    """Raises RuntimeError for a user without a home."""
    folder = os.environ.get("XDG_STATE_HOME") or Path.home() / ".local" / "state"
    return Path(folder) / "instobj" / "written.sha256"
