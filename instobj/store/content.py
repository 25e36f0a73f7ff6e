"""Content-addressed store of stage results: a folder per stage and key, complete or absent.

The key is the SHA-256 of the stage's name, its version and everything that it depends on. A
stage writes into a temporary folder that is renamed when it is complete, so an interrupted run
leaves whole results only and the next run goes on from them.
"""

from __future__ import annotations

import hashlib
import json
import os
import shutil
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from design.errors import StoreError

RECORD = "stage.json"
_TEMPORARY = ".making-"


@dataclass(frozen=True)
class StoredResult:
    """A complete stage result: where it lies, whether it was already there, and what it took."""

    stage: str
    key: str
    folder: Path
    reused: bool
    seconds: float


def store_root() -> Path:
    """`INSTOBJ_STORE`, or `.instobj` in the current folder."""
    return Path(os.environ.get("INSTOBJ_STORE", ".instobj")).absolute()


def content_key(content: Any) -> str:
    """SHA-256 of JSON-able content, independent of the order of keys."""
    return hashlib.sha256(json.dumps(content, sort_keys=True).encode()).hexdigest()


def file_key(path: Path) -> str:
    """SHA-256 of a file's bytes."""
    with path.open("rb") as stream:
        return hashlib.file_digest(stream, "sha256").hexdigest()


def stored(
    root: Path, stage: str, inputs: dict[str, Any], make: Callable[[Path], None]
) -> StoredResult:
    """The result of `make(folder)` for these inputs: found in the store, or made and kept.

    Raises
    ------
    StoreError
        The store cannot be written.
    """
    key = content_key({"stage": stage, "inputs": inputs})
    folder = root / stage / key[:24]
    if (folder / RECORD).is_file():
        return _found(stage, key, folder)
    temporary = _temporary_folder(root, stage, key)
    started = time.perf_counter()
    try:
        make(temporary)
        seconds = time.perf_counter() - started
        record = {"stage": stage, "key": key, "seconds": round(seconds, 3), "inputs": inputs}
        (temporary / RECORD).write_text(json.dumps(record, indent=1), encoding="utf-8")
        _move_into_place(temporary, folder)
    except StoreError:
        raise
    except OSError as error:
        raise StoreError(
            f"cannot keep results in the store {root}: {error}. Make room, or set INSTOBJ_STORE to "
            "a writable folder"
        ) from error
    finally:
        shutil.rmtree(temporary, ignore_errors=True)
    return StoredResult(stage, key, folder, False, seconds)


def _found(stage: str, key: str, folder: Path) -> StoredResult:
    record = json.loads((folder / RECORD).read_text(encoding="utf-8"))
    return StoredResult(stage, key, folder, True, record["seconds"])


def _temporary_folder(root: Path, stage: str, key: str) -> Path:
    temporary = root / f"{_TEMPORARY}{stage}-{key[:12]}-{os.getpid()}"
    try:
        root.mkdir(parents=True, exist_ok=True)
        _remove_abandoned(root)
        temporary.mkdir()
    except OSError as error:
        raise StoreError(
            f"cannot write the store {root}: {error.strerror}. Set INSTOBJ_STORE to a writable folder"
        ) from error
    return temporary


def _remove_abandoned(root: Path) -> None:
    """Temporary folders of processes that no longer run (killed, or out of power)."""
    for folder in root.glob(f"{_TEMPORARY}*"):
        pid = folder.name.rsplit("-", 1)[-1]
        if pid.isdigit() and (int(pid) == os.getpid() or not _runs(int(pid))):
            shutil.rmtree(folder, ignore_errors=True)


def _runs(pid: int) -> bool:
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    except PermissionError:
        return True
    return True


def _move_into_place(temporary: Path, folder: Path) -> None:
    folder.parent.mkdir(parents=True, exist_ok=True)
    if folder.exists() and not (folder / RECORD).is_file():
        shutil.rmtree(folder)
    try:
        temporary.rename(folder)
    except OSError:
        if not (folder / RECORD).is_file():  # another process may have finished the same result
            raise
