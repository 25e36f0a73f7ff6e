"""Lines and single characters of Grbl 1.1 and grblHAL, controllers of most small milling machines.

Every line sent is answered by `ok` or `error:n`, in their order. `ALARM:n`, the greeting after a reset
and `[…]` remarks come by themselves; `?` is answered by `<State|MPos:x,y,z|…>` whenever it is sent
(github.com/gnea/grbl, doc/markdown/interface.md).
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from design.errors import InputError
from instobj.bench.rig.replies import (
    Alarm,
    Done,
    Greeting,
    Refused,
    Reply,
    Setting,
    State,
    Travel,
)

RECEIVE_BYTES = 127
"""Bytes that are safe to fill, of its 128 for lines that it has not read yet."""
_NEEDED = {"$22": 1, "$20": 1, "$13": 0}
_TRAVEL, _PULL_OFF = ("$130", "$131", "$132"), "$27"
_KEPT_POSITION = 2
"""The alarm after which the machine still knows where it is."""
_ALARMS = {
    1: "a limit switch was hit; the position is lost",
    2: "a move would leave the machine's travel",
    3: "reset while moving; the position is lost",
    6: "reset while homing",
    7: "a door was opened while homing",
    8: "homing did not leave the limit switch",
    9: "homing found no limit switch",
    10: "the emergency stop is pressed",
    11: "it must be homed first",
}
_ERRORS = {
    1: "a letter was expected",
    2: "a number is damaged",
    3: "unknown $ command",
    5: "homing is not enabled ($22)",
    8: "only possible when idle",
    9: "locked until it is homed",
    11: "the line is too long",
    20: "unknown G-code",
    22: "no feed rate",
    24: "two G-codes want the axes",
    26: "axes are missing",
    28: "a value is missing",
    33: "the target is no place",
    36: "unused words",
}
_STATUS_LINE = re.compile(r"<([A-Z][a-z]+)(?::(\d+))?\|(.*)>")
_SETTING = re.compile(r"(\$\d+)=(-?\d+(?:\.\d+)?)")
_GREETING = re.compile(r"(Grbl|GrblHAL) |.*for help\]$", re.IGNORECASE)
"""Greeting of Grbl and grblHAL; the end alone where the beginning was lost."""
_AXES = 3
"""Machines may have more, which they report behind X, Y and Z."""
_NUMBERED = re.compile(r"(error|ALARM):(\d+)")


@dataclass
class GrblSpeech:
    """Bytes to replies, lines to bytes; remembers the unfinished line and the offset of work coordinates."""

    status: bytes = b"?"
    damaged: int = 0
    _rest: bytes = b""
    _offset_mm: tuple[float, ...] | None = None

    def encode(self, line: str) -> bytes:
        """Return the bytes of a line: this is the dialect in which lines are written here."""
        return f"{line}\n".encode()

    def restart(self) -> None:
        """Nothing is remembered that a reset ends."""

    def feed(self, data: bytes) -> list[Reply]:
        """Replies that `data` completes; remarks are skipped, damaged lines counted."""
        *lines, self._rest = (self._rest + data).split(b"\n")
        texts = [line.decode("ascii", "replace").strip() for line in lines]
        replies = [self._reply(text) for text in texts if text and text[0] not in "[>"]
        self.damaged += sum(reply is None for reply in replies)
        return [reply for reply in replies if reply is not None]

    def _reply(self, text: str) -> Reply | None:
        if text == "ok":
            return Done()
        if _GREETING.match(text):
            return Greeting()
        if match := _NUMBERED.fullmatch(text):
            return _fault(text, match[1], int(match[2]))
        if match := _SETTING.fullmatch(text):
            return Setting(match[1], float(match[2]))
        if match := _STATUS_LINE.fullmatch(text):
            return self._state(match[1], match[2], match[3].split("|"))
        return None

    def _state(self, name: str, detail: str | None, fields: list[str]) -> State | None:
        """Work positions become the machine's by the offset, which Grbl sends now and then."""
        values = dict(field.split(":", 1) for field in fields if ":" in field)
        try:
            given = {
                key: tuple(float(number) for number in values[key].split(","))[:_AXES]
                for key in ("MPos", "WPos", "WCO")
                if key in values
            }
        except ValueError:
            return None
        if any(
            len(numbers) != _AXES or not np.isfinite(numbers).all() for numbers in given.values()
        ):
            return None
        self._offset_mm = given.get("WCO", self._offset_mm)
        position = given.get("MPos")
        if position is None and "WPos" in given and self._offset_mm is not None:
            pairs = zip(given["WPos"], self._offset_mm, strict=True)
            position = tuple(work + offset for work, offset in pairs)
        if position is None:
            return None
        x, y, z = position
        return State(name, None if detail is None else int(detail), (x, y, z))


def _fault(text: str, kind: str, code: int) -> Reply:
    if kind == "error":
        return Refused(f"{text} ({_ERRORS.get(code, 'unknown')})")
    return Alarm(f"{text} ({_ALARMS.get(code, 'unknown')})", code == _KEPT_POSITION)


def grbl_travel(settings: Mapping[str, float]) -> Travel:
    """Room of a machine by its settings: after homing from minus the travel to 0.

    Raises
    ------
    InputError
        A setting is missing, homing or soft limits are off, or it reports inches.
    """
    missing = [name for name in (*_NEEDED, _PULL_OFF, *_TRAVEL) if name not in settings]
    if missing:
        raise InputError(f"the machine did not tell {', '.join(missing)}. Is it Grbl 1.1?")
    # grblHAL packs further switches into higher bits of $20 and $22.
    wrong = [
        f"{name}={value}" for name, value in _NEEDED.items() if int(settings[name]) & 1 != value
    ]
    if wrong:
        raise InputError(
            f"set {', '.join(wrong)} on the machine: homing by limit switches ($22) and soft limits ($20) "
            "keep the tip where coordinates mean something, and it must report mm ($13)"
        )
    x, y, z = (-settings[name] for name in _TRAVEL)
    return Travel((x, y, z), (0.0, 0.0, 0.0), -settings[_PULL_OFF])
