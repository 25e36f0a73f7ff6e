"""Binary messages to the page: frames with contacts, and the state of everything else.

All numbers are little-endian. A message of frames begins with 40 bytes:

- `IOF1`, rows (u2), contacts (u1), labels (u1), number of the message (u4), rows that were dropped for
  this viewer so far (u4)
- seconds since 1970 (f8) at which the newest row arrived, and at which the row arrived that the
  contacts were read from (0: none was)
- the newest row's time (f8, s, by the board's clock)

After it, in f4: for each row its age against the newest (s) and the change of every channel (counts; NaN:
no reading), then `CONTACT` for each contact, then `LABEL` for each label. Places, normals and forces are
in the object's frame. A message of state is `IOS1` and JSON. The page answers a message of frames with
its number (u4) once it is drawn.
"""

from __future__ import annotations

import json
import struct
from dataclasses import dataclass
from typing import Any

import numpy as np
from jaxtyping import Float

FRAMES, STATE = b"IOF1", b"IOS1"
_HEAD = struct.Struct("<4sHBBIIddd")
CONTACT = ("face", "x_mm", "y_mm", "radius_mm", "force_n", "halfwidth_n", "point", "normal", "pull")
"""Columns of a contact; the last three are vectors (mm, unit, N on the object)."""
LABEL = ("face", "x_mm", "y_mm", "force_n", "point", "normal")
CONTACT_WIDTH, LABEL_WIDTH = 15, 10


@dataclass(frozen=True)
class Head:
    """Head of a message of frames."""

    number: int
    dropped_rows: int
    arrived_s: float
    read_s: float
    time_s: float


def frames_message(
    head: Head,
    rows: Float[np.ndarray, "row columns"],
    contacts: Float[np.ndarray, "contact 15"],
    labels: Float[np.ndarray, "label 10"],
) -> bytes:
    """One message; `rows` are age (s) and changes (counts)."""
    counted = len(rows), len(contacts), len(labels)
    started = _HEAD.pack(
        FRAMES, *counted, head.number, head.dropped_rows, head.arrived_s, head.read_s, head.time_s
    )
    return started + b"".join(part.astype("<f4").tobytes() for part in (rows, contacts, labels))


def state_message(state: dict[str, Any]) -> bytes:
    """A message of state; numbers that are none become null."""
    return STATE + json.dumps(state, allow_nan=False).encode()
