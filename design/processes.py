"""Limits of this machine, and Python programs in separate processes that keep to them.

Code that may crash, hang or fill the memory (readers of foreign files, the mesher) runs apart: there,
each of these is one error.
"""

from __future__ import annotations

import ctypes
import errno
import functools
import os
import shutil
import signal
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from contextlib import AbstractContextManager
from pathlib import Path
from typing import Any

from threadpoolctl import ThreadpoolController

from design.errors import FullDisk, InputError

MEMORY_SWITCH = "INSTOBJ_MEMORY_GIB"
ONE_THREAD = {"OMP_NUM_THREADS": "1", "MKL_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
"""Environment of processes that compute, before they load what reads it: threads of a solver wait for each
other where cores are shared. More processes (`--workers`) take more cores."""
_GIB = 2.0**30
"""Bytes in a GiB."""


def one_blas_thread() -> AbstractContextManager[Any]:
    """A context in which linear algebra of loaded libraries (NumPy's, SciPy's, MKL's) takes one thread."""
    return _loaded_libraries(len(sys.modules)).limit(limits=1, user_api="blas")


@functools.lru_cache(maxsize=1)
def _loaded_libraries(_modules: int) -> ThreadpoolController:
    """Look for them again where modules were imported since, which may bring libraries: it takes 8 ms."""
    return ThreadpoolController()


def load_library(path: str) -> ctypes.CDLL:
    """Load a library of linear algebra, so that `one_blas_thread` finds it from then on."""
    library = ctypes.CDLL(path)
    _loaded_libraries.cache_clear()
    return library


class ChildFailed(Exception):
    """A separate process that did not do its work; the text says why."""


class ChildTooSlow(ChildFailed):
    """One that was ended when its time was over."""


def run_child(
    arguments: Sequence[str],
    folder: Path,
    seconds: float,
    memory_gib: float | None = None,
) -> None:
    """Run Python with these arguments in a folder, at most so long and in so much memory.

    A program that fails says why in the last line of its standard error. The limit of
    memory holds on Linux alone: elsewhere a program may fill the memory until its time is over.

    Raises
    ------
    ChildTooSlow
        It did not end in time.
    ChildFailed
        It crashed, ran out of memory, or ended with another code than 0.
    FullDisk
        It could not write its temporary files.
    """
    with tempfile.TemporaryFile("w+", errors="replace") as said:
        child = subprocess.Popen(
            [sys.executable, *arguments], cwd=folder, stdout=subprocess.DEVNULL, stderr=said
        )
        try:
            limit_memory(child.pid, memory_gib)
            child.wait(seconds)
        except subprocess.TimeoutExpired:
            raise ChildTooSlow(f"it did not end within {seconds:g} s") from None
        finally:
            child.kill()
            child.wait()
        said.seek(0)
        if child.returncode != 0:
            text = said.read()
            _require_room(text, folder)
            raise ChildFailed(reason_of(child.returncode, text, memory_gib))


def machine_memory_gib() -> float | None:
    """Memory that this process may use: `INSTOBJ_MEMORY_GIB`, the machine's, or its container's limit.

    None if unknown.

    Raises
    ------
    InputError
        `INSTOBJ_MEMORY_GIB` is not a positive number.
    """
    limit_text = os.environ.get(MEMORY_SWITCH)
    if limit_text is not None:
        try:
            gib = float(limit_text)
        except ValueError:
            gib = 0.0
        if not gib > 0:
            raise InputError(
                f"{MEMORY_SWITCH} must be a positive number of GiB; got {limit_text!r}. Fix it"
            )
        return gib
    if not hasattr(os, "sysconf") or "SC_PHYS_PAGES" not in os.sysconf_names:
        return None
    installed_gib = os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE") / _GIB
    limit = Path("/sys/fs/cgroup/memory.max")
    text = limit.read_text().strip() if limit.is_file() else ""
    return min(installed_gib, int(text) / _GIB) if text.isdigit() else installed_gib


def limit_memory(pid: int, gib: float | None) -> None:
    if gib is None or sys.platform != "linux":
        return
    import resource

    most = int(gib * _GIB)
    try:
        resource.prlimit(pid, resource.RLIMIT_AS, (most, most))
    except (ProcessLookupError, ValueError):  # it has ended, or may not have so much anyway
        return


def _require_room(said: str, folder: Path) -> None:
    """Raise FullDisk where a program said, as Python does, that the system had no room."""
    for number in (errno.ENOSPC, errno.EDQUOT, errno.EFBIG):
        if f"[Errno {number}]" in said:
            reason = os.strerror(number)
            free = shutil.disk_usage(folder).free / 1e6
            raise FullDisk(
                f"cannot write temporary files in {folder.parent}: {reason}; {free:.1f} MB are free, and "
                "more are needed. Make room there, or set TMPDIR to a folder elsewhere",
                folder,
                reason,
            )


def reason_of(code: int, said: str, memory_gib: float | None) -> str:
    if memory_gib is not None and ("MemoryError" in said or "bad_alloc" in said):
        return f"it needs more than {memory_gib:.3g} GiB of memory"
    if code < 0:
        return f"it crashed ({signal.Signals(-code).name})"
    lines = said.strip().splitlines()
    return lines[-1] if lines else f"it ended with code {code}"
