"""Content-addressed store of stage results: a folder per stage and key, complete or absent.

The key is the SHA-256 of the stage's name, its version and everything that it depends on, the
content of the results that it is made from included. A stage writes into a temporary folder that is
on the disk before it is renamed, so an interrupted run leaves whole results only and the next run
goes on from them. A result is verified when it is found; a damaged one is set aside and made again.
"""

from __future__ import annotations

import errno
import os
import shutil
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from design.errors import StoreError
from design.files import full_disk_told
from instobj.store.keys import stage_key
from instobj.store.lease import hold_lease, remove_abandoned
from instobj.store.progress import ProgressLine
from instobj.store.record import (
    RECORD,
    DamagedResult,
    content_of,
    flush_to_disk,
    read_record,
    verify,
    verify_by_hash,
    write_record,
)
from instobj.store.shared import SharedStore, shared_store

Say = Callable[[str], None]
SET_ASIDE = ".damaged-"


@dataclass(frozen=True)
class StoredResult:
    """A complete stage result.

    Attributes
    ----------
    stage, key : what it is, and the hash of everything that it depends on
    folder : where its files lie
    reused : whether it was already there
    seconds : what it took to make
    content : SHA-256 of its files
    """

    stage: str
    key: str
    folder: Path
    reused: bool
    seconds: float
    content: str

    @property
    def origin(self) -> str:
        """Key and content, on which every result that is made from this one depends."""
        return f"{self.key}-{self.content}"


def store_root() -> Path:
    """`INSTOBJ_STORE`, or `.instobj` in the current folder."""
    return Path(os.environ.get("INSTOBJ_STORE", ".instobj")).absolute()


def _say(message: str) -> None:
    ProgressLine().say(message)


def stored(
    root: Path, stage: str, inputs: dict[str, Any], make: Callable[[Path], None], say: Say = _say
) -> StoredResult:
    """The result of `make(folder)` for these inputs: found in the store, or made and kept.

    `say` gets a line where a damaged result is made again.

    Raises
    ------
    StoreError
        The store cannot be written, or a file in it cannot be read for lack of permission.
    """
    key, shared = stage_key(stage, inputs), shared_store()
    kept = find(root, stage, key, say)
    if kept is not None:
        return kept
    with _temporary_folder(root, stage, key) as temporary:
        started = time.perf_counter()
        make(temporary)
        seconds = time.perf_counter() - started
        content = write_record(temporary, stage, key, seconds, inputs)
        made = StoredResult(stage, key, _folder(root, stage, key), False, seconds, content)
        result = _moved_into_place(temporary, made, root, say)
    if shared is not None:
        shared.send(stage, key, result.folder)
    return result


def find(root: Path, stage: str, key: str, say: Say = _say) -> StoredResult | None:
    """The result of a key: in this machine's store, or fetched from the shared one; None elsewhere.

    What the shared store lacks is sent to it.

    Raises
    ------
    StoreError
        As `stored`, and where the shared store does not answer.
    """
    kept, shared = _found(root, stage, key, say), shared_store()
    if shared is None:
        return kept
    if kept is None:
        return _fetched(shared, root, stage, key, say)
    shared.send(stage, key, kept.folder)
    return kept


def _fetched(
    shared: SharedStore, root: Path, stage: str, key: str, say: Say
) -> StoredResult | None:
    """A result of the shared store, now also in this machine's; a damaged one counts as none."""
    with _temporary_folder(root, stage, key) as temporary:
        try:
            record = shared.fetch(stage, key, temporary)
        except DamagedResult as damage:
            say(f"{stage}: the result in {shared.url} is damaged ({damage}) and is made again")
            return None
        if record is None:
            return None
        folder = _folder(root, stage, key)
        fetched = StoredResult(stage, key, folder, True, record["seconds"], content_of(record))
        return _moved_into_place(temporary, fetched, root, say)


def _folder(root: Path, stage: str, key: str) -> Path:
    return root / stage / key[:24]


def _found(root: Path, stage: str, key: str, say: Say) -> StoredResult | None:
    """The verified result, if it is there; a damaged one is set aside."""
    folder, by_hash = _folder(root, stage, key), verify_by_hash()
    if not folder.exists():
        return None
    try:
        with suppress(OSError):  # a store that can be read only, or a folder without a record
            hold_lease(root)
            os.utime(folder / RECORD)  # when it was last used
        record = read_record(folder)
        if record["key"] != key:
            raise DamagedResult(f"{RECORD} is of another result")
        verify(folder, record, by_hash)
    except DamagedResult as damage:
        _set_aside(folder, damage, say)
        return None
    return StoredResult(stage, key, folder, True, record["seconds"], content_of(record))


def _set_aside(folder: Path, damage: DamagedResult, say: Say) -> None:
    number = 1
    while (aside := folder.with_name(f"{folder.name}{SET_ASIDE}{number}")).exists():
        number += 1
    try:
        folder.rename(aside)
    except FileNotFoundError:  # another process has set it aside
        return
    except OSError as error:
        raise StoreError(
            f"{folder} is damaged ({damage}) and cannot be set aside: {error.strerror}. Make the "
            "store writable, or set INSTOBJ_STORE to another folder"
        ) from error
    say(f"{folder.parent.name}: the stored result was damaged ({damage}); kept as {aside.name}")


@contextmanager
def _temporary_folder(root: Path, stage: str, key: str) -> Iterator[Path]:
    """A folder to make a result in, removed afterwards."""
    try:
        with full_disk_told(root / stage, root):
            lease = hold_lease(root)
            remove_abandoned(root, lease.now())
            temporary = lease.temporary(root, f"{stage}-{key[:12]}")
    except StoreError:
        raise
    except OSError as error:
        raise StoreError(
            f"cannot write the store {root}: {error.strerror}. Set INSTOBJ_STORE to a writable folder"
        ) from error
    try:
        with full_disk_told(root / stage, temporary):
            yield temporary
    except StoreError:
        raise
    except OSError as error:
        raise StoreError(
            f"cannot keep results in the store {root}: {error}. Set INSTOBJ_STORE to a writable folder"
        ) from error
    finally:
        shutil.rmtree(temporary, ignore_errors=True)


def _moved_into_place(temporary: Path, made: StoredResult, root: Path, say: Say) -> StoredResult:
    """The result where it belongs; another process's where that has made the same meanwhile."""
    made.folder.parent.mkdir(parents=True, exist_ok=True)
    while True:
        try:
            temporary.rename(made.folder)
        except OSError as error:
            if error.errno not in (errno.ENOTEMPTY, errno.EEXIST):
                raise
            if (made_elsewhere := _found(root, made.stage, made.key, say)) is not None:
                return made_elsewhere
        else:
            flush_to_disk(made.folder.parent)
            flush_to_disk(root)
            return made
