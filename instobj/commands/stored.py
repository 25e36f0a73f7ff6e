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


def look_after_store(
    root: Path, by_hash: bool, space: str | None, older_than: str | None
) -> dict[str, Any]:
    """Return what lies in the store, after space was freed where that is asked.

    Raises
    ------
    InputError
        A size or an age that cannot be read, or no store.
    StoreError
        The store cannot be written.
    """
    least_bytes = None if space is None else _read(space, _BYTES, "--free", "5GB")
    age_s = None if older_than is None else _read(older_than, _SECONDS, "--older-than", "30d")
    if not root.is_dir():
        raise InputError(
            f"there is no store {root}. Go to the folder where instobj ran, or set INSTOBJ_STORE"
        )
    freed: list[Entry] = []
    if least_bytes is not None or age_s is not None:
        freed = _freed(root, least_bytes, age_s or 0.0)
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


def _read(text: str, units: dict[str, int], option: str, example: str) -> int:
    match = re.fullmatch(r"(\d+(?:\.\d+)?)\s*([A-Za-z]+)", text.strip())
    names = {name.lower(): count for name, count in units.items()}
    if match is None or match[2].lower() not in names:
        raise InputError(
            f"{option} must be a number with one of {', '.join(units)}; got {text!r}. Give it like "
            f"{example}"
        )
    return round(float(match[1]) * names[match[2].lower()])


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
