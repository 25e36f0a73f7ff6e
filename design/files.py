"""Files that are either complete or absent: written to a temporary name, then renamed."""

from __future__ import annotations

import errno
import os
import shutil
import stat
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from design.errors import FullDisk, InputError, StoreError

_NO_ROOM = {
    errno.ENOSPC: "no space left on its disk",
    errno.EDQUOT: "your quota on its disk is used up",
    errno.EFBIG: "the system allows no file as large",
}
_BLOCK_BYTES = 2**24
"""Bytes written at a time when room on the disk is taken beforehand."""


@contextmanager
def atomic_path(target: Path | str) -> Iterator[Path]:
    """Yield a temporary path next to `target` (same suffix); rename it on success, else remove it.

    Write what native libraries make (VTK, HDF5, STEP) through memory: they crash, or end without a
    word, on a disk that is full.

    Raises
    ------
    StoreError
        The folder cannot be made or written, or its disk is full.
    """
    target = Path(target)
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        handle, name = tempfile.mkstemp(
            prefix=f".{target.stem}.", suffix=target.suffix, dir=target.parent
        )
    except OSError as error:
        raise _cannot_write(target, error) from error
    os.close(handle)
    temporary = Path(name)
    try:
        with full_disk_told(target, temporary):
            yield temporary
        temporary.chmod(0o644)
        try:
            temporary.replace(target)
        except OSError as error:
            raise _cannot_write(target, error) from error
    finally:
        temporary.unlink(missing_ok=True)


@contextmanager
def full_disk_told(target: Path, written: Path) -> Iterator[None]:
    """Turn the system's error of a full disk into one that says how much room there was.

    Parameters
    ----------
    written : what was written of `target` so far, a file or a folder

    Raises
    ------
    FullDisk
        The disk, or the user's share of it, is full; of `target`, whatever file of `written` failed.
    """
    try:
        yield
    except OSError as error:
        reason = _NO_ROOM.get(error.errno or 0)
        if error.errno is None and " requested and " in str(
            error
        ):  # ndarray.tofile drops the number
            reason = _NO_ROOM[errno.ENOSPC]
        if isinstance(error, FullDisk) and written in error.path.parents:
            reason = error.reason
        if reason is None:
            raise
        files = [path for path in (written, *written.rglob("*")) if path.is_file()]
        megabytes = sum(path.stat().st_size for path in files) / 1e6
        free = shutil.disk_usage(written.parent).free / 1e6
        raise FullDisk(
            f"cannot write {target}: {reason}; {free:.1f} MB are free beside the {megabytes:.1f} MB "
            "that were written, and it needs more. Make room there, or choose another folder (--out; "
            "for stored results INSTOBJ_STORE, for temporary files TMPDIR)",
            target,
            reason,
        ) from error


def write_whole(handle: int, content: bytes) -> None:
    """Write all bytes to an open file; the system writes the first of them alone as a disk fills.

    Raises
    ------
    OSError
        The disk is full; some bytes may have been written.
    """
    rest = memoryview(content)
    while rest:
        rest = rest[os.write(handle, rest) :]


def reserve_room(path: Path, start: int) -> None:
    """Have the disk keep all bytes of a file from `start` on, which a memory map will fill.

    A map of a file with holes ends the process (SIGBUS) where the disk is full.

    Raises
    ------
    OSError
        The disk is full.
    """
    size = path.stat().st_size
    with path.open("r+b") as file:
        if hasattr(os, "posix_fallocate"):
            os.posix_fallocate(file.fileno(), 0, size)
            return
        file.seek(start)
        for done in range(start, size, _BLOCK_BYTES):
            file.write(bytes(min(_BLOCK_BYTES, size - done)))


def _cannot_write(target: Path, error: OSError) -> StoreError:
    """Return what is in the way, where something is; else what the system says."""
    file = next(
        (parent for parent in target.parents if parent.exists() and not parent.is_dir()), None
    )
    why = str(error.strerror)
    if file is not None:
        why = f"{file} is a file, not a folder"
    elif target.is_dir():
        why = "a folder of that name is there"
    return StoreError(f"cannot write {target}: {why}. Choose a writable folder with --out")


def require_regular_file(path: Path | str, missing: str) -> Path:
    """The path of a file that can be read to its end: no folder, pipe or device.

    Raises
    ------
    InputError
        With the text `missing` where nothing is there; else with what is there instead.
    """
    path = Path(path)
    try:
        mode = path.stat().st_mode
    except (FileNotFoundError, NotADirectoryError):
        raise InputError(missing) from None
    except ValueError:  # a null byte
        raise InputError(f"{str(path)!r} is not a file name. Fix the name") from None
    except OSError as error:
        shown = str(path) if len(str(path)) < 120 else f"{str(path)[:120]}…"
        raise InputError(f"cannot read {shown}: {error.strerror}. Fix the name") from None
    if not stat.S_ISREG(mode):
        what = "a folder" if stat.S_ISDIR(mode) else "a pipe, socket or device"
        raise InputError(f"{path} is {what}, not a file. Give a file")
    return path
