"""Space that stored results take: what lies in a store, whether it is whole, and what may go."""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

from instobj.store.content import SET_ASIDE
from instobj.store.lease import hold_lease, oldest_start, remove_abandoned
from instobj.store.record import RECORD, DamagedResult, UnhashedResult, read_record, verify

WHOLE, DAMAGED, ASIDE, UNFINISHED = "result", "damaged", "set aside", "unfinished"
EARLIER = "earlier version"
UNFINISHED_TRAINING = "unfinished"
"""Folder next to the stages, of trainings that can go on."""


@dataclass(frozen=True)
class Entry:
    """A folder of a store.

    Attributes
    ----------
    stage, folder : whose it is, and where it lies
    size : of all its files, bytes
    last_used : s since 1970, by the store's file system
    state : `result`, `damaged`, `set aside`, `unfinished`, or of an `earlier version`, used no more
    problem : what is wrong with a damaged one
    """

    stage: str
    folder: Path
    size: int
    last_used: float
    state: str
    problem: str = ""


def entries(root: Path, by_hash: bool = False) -> list[Entry]:
    """Return what lies in a store, least recently used first.

    Parameters
    ----------
    by_hash : whether all bytes are read and compared with the records, not names and sizes alone
    """
    all_entries = [_entry(folder, by_hash) for folder in root.glob("[!.]*/*") if folder.is_dir()]
    return sorted(all_entries, key=lambda entry: entry.last_used)


def free(root: Path, may_go: Callable[[Entry], bool], least_bytes: int | None) -> list[Entry]:
    """Remove entries, what is no use first, then the least recently used.

    What a process with a live lease has used since it began stays, whatever is asked.

    Parameters
    ----------
    may_go : whether an entry may be removed
    least_bytes : no more is removed once this much is free; None removes all that may go

    Returns
    -------
    list[Entry]
        What was removed.
    """
    now = hold_lease(root).now()
    remove_abandoned(root, now)
    in_use_since, removed = oldest_start(root, now), []
    useless_first = sorted(entries(root), key=lambda entry: entry.state in (WHOLE, UNFINISHED))
    for entry in useless_first:
        if least_bytes is not None and sum(gone.size for gone in removed) >= least_bytes:
            break
        if entry.last_used < in_use_since and may_go(entry) and _removed(root, entry):
            removed.append(entry)
    return removed


def _removed(root: Path, entry: Entry) -> bool:
    """Move an entry out of the way, then remove it; put back what was used at the last moment."""
    away = hold_lease(root).temporary(root, f"free-{entry.stage}") / "entry"
    try:
        entry.folder.rename(away)
        if _last_used(away) > entry.last_used:
            away.rename(entry.folder)
            return False
    except OSError:  # another process removed it, or made it again meanwhile
        return False
    finally:
        shutil.rmtree(away.parent, ignore_errors=True)
    return True


def _entry(folder: Path, by_hash: bool) -> Entry:
    stage, problem = folder.parent.name, ""
    state = ASIDE if SET_ASIDE in folder.name else WHOLE
    if stage == UNFINISHED_TRAINING:
        state = UNFINISHED
    elif state == WHOLE:
        try:
            verify(folder, read_record(folder), by_hash)
        except UnhashedResult:
            state = EARLIER
        except DamagedResult as damage:
            state, problem = DAMAGED, str(damage)
    size = sum(status.st_size for status in _statuses(folder))
    return Entry(stage, folder, size, _last_used(folder), state, problem)


def _last_used(folder: Path) -> float:
    """When the record was touched last; where there is none, when a file was changed last."""
    try:
        return (folder / RECORD).stat().st_mtime
    except OSError:
        return max((status.st_mtime for status in _statuses(folder)), default=0.0)


def _statuses(folder: Path) -> Iterator[os.stat_result]:
    """Size of all files; one that goes meanwhile is none."""
    for path in folder.rglob("*"):
        try:
            status = path.stat()
        except FileNotFoundError:
            continue
        if path.is_file():
            yield status
