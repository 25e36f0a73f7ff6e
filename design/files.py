"""Files that are either complete or absent: written to a temporary name, then renamed."""

from __future__ import annotations

import os
import stat
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from design.errors import InputError, StoreError


@contextmanager
def atomic_path(target: Path | str) -> Iterator[Path]:
    """Yield a temporary path beside `target` (same suffix); rename it on success, else remove it.

    Raises
    ------
    StoreError
        The folder cannot be made or written.
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
        yield temporary
        temporary.chmod(0o644)
        try:
            temporary.replace(target)
        except OSError as error:
            raise _cannot_write(target, error) from error
    finally:
        temporary.unlink(missing_ok=True)


def _cannot_write(target: Path, error: OSError) -> StoreError:
    """What is in the way, where something is; else what the system says."""
    file = next((one for one in target.parents if one.exists() and not one.is_dir()), None)
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
