"""Record of a stored result: size and hash of each of its files, so that damage is noticed."""

from __future__ import annotations

import json
import os
from functools import cache
from pathlib import Path
from typing import Any

from design.errors import InputError, StoreError
from instobj.store.keys import content_key, file_key

RECORD = "stage.json"
_SWITCH = "INSTOBJ_STORE_VERIFY"


class DamagedResult(StoreError):
    """A stored result that is not what was stored; the text says what is wrong with it."""


class UnhashedResult(DamagedResult):
    """A result of an earlier version, whose record holds no hashes."""


def write_record(folder: Path, stage: str, key: str, seconds: float, inputs: dict[str, Any]) -> str:
    """Record the files of a folder, all of it on the disk when this returns.

    Returns
    -------
    str
        SHA-256 of the content: of the files' names, sizes and hashes.
    """
    files = {
        path.relative_to(folder).as_posix(): {
            "bytes": path.stat().st_size,
            "sha256": file_key(path),
        }
        for path in result_files(folder)
    }
    record: dict[str, Any] = {"stage": stage, "key": key, "seconds": round(seconds, 3)}
    record |= {"inputs": inputs, "files": files}
    record["digest"] = content_key(record)
    (folder / RECORD).write_text(json.dumps(record, indent=1), encoding="utf-8")
    flush_tree(folder)
    return content_key(files)


def read_record(folder: Path) -> dict[str, Any]:
    """A result's record, itself checked against the digest that it holds.

    Raises
    ------
    DamagedResult
        There is none, or it is not as it was written.
    """
    try:
        record = json.loads((folder / RECORD).read_text(encoding="utf-8"))
        rest = {name: value for name, value in record.items() if name != "digest"}
        digest = record.get("digest")
    except (FileNotFoundError, NotADirectoryError):
        raise DamagedResult(f"{RECORD} is missing") from None
    except PermissionError:
        raise _unreadable(folder / RECORD) from None
    except (OSError, ValueError, AttributeError, RecursionError):
        raise DamagedResult(f"{RECORD} cannot be read") from None
    if digest is None:
        raise UnhashedResult(f"{RECORD} holds no hashes")
    if digest != content_key(rest):
        raise DamagedResult(f"{RECORD} was changed")
    return record


def verify(folder: Path, record: dict[str, Any], by_hash: bool) -> None:
    """Compare the files of a folder with its record.

    Parameters
    ----------
    by_hash : whether bytes are compared too, not names and sizes alone; each file is read once per
        process, unless it is touched

    Raises
    ------
    DamagedResult
        A file is missing, has another size or other bytes, or was added.
    """
    files = record["files"]
    for path in result_files(folder):
        name = path.relative_to(folder).as_posix()
        if name not in files and not path.name.startswith("."):
            raise DamagedResult(f"{name} was added")
    for name, expected in files.items():
        _verify_file(folder / name, name, expected, by_hash)


def verify_by_hash() -> bool:
    """Return what `INSTOBJ_STORE_VERIFY` asks for: `hash` (if unset) or `size`."""
    how = os.environ.get(_SWITCH, "hash")
    if how not in ("hash", "size"):
        raise InputError(f"{_SWITCH} must be 'hash' or 'size'; got {how!r}. Set one, or unset it")
    return how == "hash"


def content_of(record: dict[str, Any]) -> str:
    """SHA-256 of the content, as `write_record` returned it."""
    return content_key(record["files"])


def result_files(folder: Path) -> list[Path]:
    """Files of a result, at any depth, without its record."""
    return [
        path for path in sorted(folder.rglob("*")) if path.is_file() and path != folder / RECORD
    ]


def _verify_file(path: Path, name: str, expected: dict[str, Any], by_hash: bool) -> None:
    try:
        status = path.stat()
        if status.st_size != expected["bytes"]:
            raise DamagedResult(f"{name} has {status.st_size} bytes instead of {expected['bytes']}")
        if not by_hash:
            return
        sha256 = _key_once(path, status.st_size, status.st_mtime_ns, status.st_ino)
    except DamagedResult:
        raise
    except (FileNotFoundError, NotADirectoryError):
        raise DamagedResult(f"{name} is missing") from None
    except PermissionError:
        raise _unreadable(path) from None
    except OSError as error:
        raise DamagedResult(f"{name} cannot be read ({error.strerror})") from None
    if sha256 != expected["sha256"]:
        raise DamagedResult(f"{name} holds other bytes than were stored")


@cache
def _key_once(path: Path, size: int, mtime_ns: int, inode: int) -> str:
    """Hash of a file, once per process while it keeps its size, time of change and inode."""
    return file_key(path)


def _unreadable(path: Path) -> StoreError:
    return StoreError(
        f"cannot read {path}: permission denied. Make it readable, or set INSTOBJ_STORE to another "
        "folder"
    )


def flush_tree(folder: Path) -> None:
    """Have the system write the files of a folder, and their names, to the disk."""
    for path in [*folder.rglob("*"), folder]:
        flush_to_disk(path)


def flush_to_disk(path: Path) -> None:
    """Have the system write a file, or the names in a folder, to the disk."""
    if path.is_dir() and os.name != "posix":  # elsewhere folders cannot be opened
        return
    handle = os.open(path, os.O_RDONLY if os.name == "posix" else os.O_RDWR)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)
