"""Care of the store: list it, verify it, free space."""

from __future__ import annotations

import re
import time
from pathlib import Path
from typing import Any

from design.errors import InputError, StoreError
from instobj.store.space import DAMAGED, Entry, entries, free

_BYTES = {"B": 1, "KB": 10**3, "MB": 10**6, "GB": 10**9, "TB": 10**12}
"""Bytes of each unit (decimal)."""
_SECONDS = {"h": 3600, "d": 86_400, "w": 604_800}
"""Seconds of each unit."""


def look_after_store(root: Path, by_hash: bool, to_free: str | None) -> dict[str, Any]:
    """Return what lies in the store, after space was freed where that is asked.

    Raises
    ------
    InputError
        A size or an age that cannot be read, or no store.
    StoreError
        The store cannot be written.
    """
    wanted = None if to_free is None else _size_or_age(to_free)
    if not root.is_dir():
        raise InputError(
            f"there is no store {root}. Go to the folder where instobj ran, or set INSTOBJ_STORE"
        )
    freed: list[Entry] = []
    if wanted is not None:
        freed = _freed(root, *wanted)
    stored = entries(root, by_hash)
    damaged = [entry for entry in stored if entry.state == DAMAGED]
    return {
        "command": "store",
        "store": str(root),
        "bytes": sum(entry.size for entry in stored),
        "freed_bytes": sum(entry.size for entry in freed),
        "freed": [_row(entry) for entry in freed],
        "entries": [_row(entry) for entry in stored],
        "verified": "hash" if by_hash else "size",
        "damaged": len(damaged),
        "texts": _texts(root, stored, freed, damaged),
        "tables": {"stored": _stage_rows(stored)} if stored else {},
    }


def _freed(root: Path, least_bytes: int | None, age_s: float) -> list[Entry]:
    latest = time.time() - age_s
    try:
        return free(root, lambda entry: entry.last_used <= latest, least_bytes)
    except OSError as error:
        raise StoreError(
            f"cannot free space in {root}: {error.strerror}. Make the store writable"
        ) from error


def _size_or_age(text: str) -> tuple[int | None, float]:
    """Bytes to free of a size, and the least age (s) of what goes; all that is older, of an age."""
    match = re.fullmatch(r"(\d+(?:\.\d+)?)\s*([A-Za-z]+)", text.strip())
    unit = match[2].lower() if match else ""
    for units in (_BYTES, _SECONDS):
        for name, count in units.items():
            if match and name.lower() == unit:
                number = round(float(match[1]) * count)
                return (number, 0.0) if units is _BYTES else (None, number)
    raise InputError(
        f"--free must be a number with one of {', '.join((*_BYTES, *_SECONDS))}; got {text!r}. Give it "
        "like 5GB, or 30d for what was not used for 30 days"
    )


def _row(entry: Entry) -> dict[str, Any]:
    return {
        "stage": entry.stage,
        "folder": str(entry.folder),
        "bytes": entry.size,
        "last_used_s": round(entry.last_used, 3),
        "state": entry.state,
        "problem": entry.problem,
    }


def _stage_rows(stored: list[Entry]) -> list[dict[str, Any]]:
    groups: dict[tuple[str, str], list[Entry]] = {}
    for entry in stored:
        groups.setdefault((entry.stage, entry.state), []).append(entry)
    now = time.time()
    return [
        {
            "stage": stage,
            "state": state,
            "number": len(group),
            "MB": sum(entry.size for entry in group) / 1e6,
            "last used, days ago": round(
                (now - max(entry.last_used for entry in group)) / _SECONDS["d"], 1
            ),
        }
        for (stage, state), group in sorted(groups.items())
    ]


def _texts(root: Path, stored: list[Entry], freed: list[Entry], damaged: list[Entry]) -> list[str]:
    total = sum(entry.size for entry in stored) / 1e6
    texts = [f"{root}: {len(stored)} entries, {total:.1f} MB"]
    if freed:
        texts.append(
            f"freed {sum(entry.size for entry in freed) / 1e6:.1f} MB, {len(freed)} entries"
        )
    texts += [f"damaged: {entry.folder} ({entry.problem})" for entry in damaged]
    if damaged:
        texts.append("Damaged results are set aside and made again when they are asked for.")
    return texts
