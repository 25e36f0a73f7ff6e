"""Leases of the processes that use a store, on this host, in containers or across a network.

A process keeps one file in `.leases`, locked, and touches it every ten seconds. It is live while it
is locked (the kernel lets go when the process ends; a long call that keeps Python's threads from
running changes nothing) or was touched within the last minute (where hosts do not share locks).
Process numbers say nothing across containers and hosts. Times are those of the file system, so
clocks of hosts may differ.
"""

from __future__ import annotations

import atexit
import json
import os
import shutil
import socket
import threading
import time
import uuid
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import IO

try:
    import fcntl
except ImportError:  # Windows: heartbeats alone
    fcntl = None

BEAT_S = 10.0
"""Time between two signs of life of a lease's holder."""
STALE_S = 60.0
"""Time without one after which a lease is void."""
_LEASES = ".leases"
_TEMPORARY = ".making-"


@dataclass(frozen=True, eq=False)
class Lease:
    """A process's claim on a store: its file, kept open and locked."""

    path: Path
    file: IO[str]

    def temporary(self, root: Path, name: str) -> Path:
        """A new folder of this process in a store, safe from others while the lease is live."""
        folder = root / f"{_TEMPORARY}{name}-{uuid.uuid4().hex[:8]}.{self.path.name}"
        folder.mkdir()
        return folder

    def now(self) -> float:
        """Time of the store's file system, s; also a heartbeat."""
        os.utime(self.path)
        return self.path.stat().st_mtime


_HELD: dict[tuple[Path, int], Lease] = {}


def hold_lease(root: Path) -> Lease:
    """The lease of this process on a store, taken when first asked for, until the process ends.

    Raises
    ------
    OSError
        The store cannot be written.
    """
    mark = root, os.getpid()  # a forked process takes its own
    if mark not in _HELD or not _HELD[mark].path.exists():
        _HELD[mark] = _take_lease(root)
    return _HELD[mark]


def oldest_start(root: Path, now: float) -> float:
    """When the first of the processes that use the store now began to, s."""
    return min((_started(path) for path in _leases(root) if _is_live(path, now)), default=now)


def remove_abandoned(root: Path, now: float) -> None:
    """Remove stale leases, and folders of work that was broken off: no live lease, a minute old."""
    for folder in list(root.glob(f"{_TEMPORARY}*")):
        lease = root / _LEASES / folder.name.rsplit(".", 1)[-1]
        with suppress(FileNotFoundError):  # another process removes it too
            if not _is_live(lease, now) and now - folder.stat().st_mtime > STALE_S:
                shutil.rmtree(folder, ignore_errors=True)
    for path in _leases(root):
        if not _is_live(path, now):
            path.unlink(missing_ok=True)


def _take_lease(root: Path) -> Lease:
    folder = root / _LEASES
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / uuid.uuid4().hex
    file = path.open("x", encoding="utf-8")
    if fcntl is not None:
        with suppress(OSError):  # a file system without locks: heartbeats alone
            fcntl.flock(file, fcntl.LOCK_EX)
    holder = {"host": socket.gethostname(), "pid": os.getpid(), "started": path.stat().st_mtime}
    file.write(json.dumps(holder))
    file.flush()
    threading.Thread(target=_beat, args=(path,), daemon=True, name="store lease").start()
    lease = Lease(path, file)
    atexit.register(_release, lease, os.getpid())
    return lease


def _beat(path: Path) -> None:
    """Touch a lease until it is gone."""
    while True:
        time.sleep(BEAT_S)
        try:
            os.utime(path)
        except FileNotFoundError:
            return
        except OSError:  # a network folder that is away for a while
            continue


def _release(lease: Lease, pid: int) -> None:
    if os.getpid() == pid:
        lease.file.close()
        lease.path.unlink(missing_ok=True)


def _leases(root: Path) -> list[Path]:
    return list((root / _LEASES).glob("*"))


def _is_live(path: Path, now: float) -> bool:
    try:
        return now - path.stat().st_mtime <= STALE_S or _is_locked(path)
    except FileNotFoundError:
        return False


def _is_locked(path: Path) -> bool:
    if fcntl is None:
        return False
    with path.open("rb+") as file:
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            return True
        except OSError:  # no locks on this file system
            return False
    return False


def _started(path: Path) -> float:
    """0 where a live lease cannot be read: then everything counts as in use."""
    try:
        return float(json.loads(path.read_text(encoding="utf-8"))["started"])
    except (OSError, ValueError, KeyError, TypeError):
        return 0.0
