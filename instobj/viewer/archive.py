"""Numbers for the page as one compressed file: a JSON head, then arrays of small integers.

Layout, gzipped without a time stamp: length of the head (4 bytes, little-endian), the head (UTF-8,
padded with spaces), the arrays one after the other, each from a multiple of 4 bytes on. The head
holds what is small, and for each array its kind, shape, place and step: a value is its integer times
the step. The largest positive integer of signed kinds stands for "no number" where `gaps` is set.
"""

from __future__ import annotations

import gzip
import json
import struct
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

_ALIGNED = 4
"""Bytes to which arrays are aligned."""


@dataclass(frozen=True)
class Stepped:
    """An array as integers and the step that they count; `gaps`: the largest one is no number."""

    counts: np.ndarray
    step: float = 1.0
    gaps: bool = False


def stepped(values: np.ndarray, kind: str, step: float | None = None) -> Stepped:
    """Round to multiples of a step, by default the finest that the integers of a kind can hold.

    Parameters
    ----------
    kind : "i1" or "i2", whose largest integer is kept for values that are not finite
    """
    most = np.iinfo(kind).max - 1
    finite = np.isfinite(values)
    largest = float(np.abs(values[finite]).max(initial=0.0))
    step = step or (largest / most if largest else 1.0)
    counts = np.where(finite, np.round(np.where(finite, values, 0.0) / step), most + 1)
    return Stepped(counts.astype(f"<{kind}"), step, gaps=not finite.all())


def pack(content: Mapping[str, Any], arrays: Mapping[str, Stepped | np.ndarray]) -> bytes:
    """One file of what is small and of the arrays; arrays without a step are kept as they are."""
    table, pieces, offset = {}, [], 0
    for name, array in arrays.items():
        stepped = array if isinstance(array, Stepped) else Stepped(array)
        data = np.ascontiguousarray(stepped.counts)
        table[name] = {
            "kind": data.dtype.str[1:],
            "shape": list(data.shape),
            "at": offset,
            "step": stepped.step,
            "gaps": stepped.gaps,
        }
        pieces.append(data.tobytes() + bytes(-data.nbytes % _ALIGNED))
        offset += len(pieces[-1])
    head = json.dumps({**content, "arrays": table}, allow_nan=False).encode()
    head += b" " * (-len(head) % _ALIGNED)
    return gzip.compress(struct.pack("<I", len(head)) + head + b"".join(pieces), 9, mtime=0)
