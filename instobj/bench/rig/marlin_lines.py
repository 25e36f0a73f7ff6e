"""Lines of Marlin 2, the controller of most printers.

Lines with a number and a check sum are carried out whole or refused; each is answered by `ok`, a move
once it is planned. `M114` says where the tip is sent and the motors' counts, `M92` the steps of a
millimetre: it stands still where both agree. `M410` stops it at once where it was built with
EMERGENCY_PARSER, but lines that wait behind it are carried out afterwards. `M118` answers with a text of
ours, after all lines before it (marlinfw.org/meta/gcode; Marlin/src/feature/e_parser.h, gcode/queue.cpp).
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

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

MARK = b"halted"
"""Text with which it answers a reset."""
_RAPID_MM_MIN = 600
"""Speed of moves in the air: a stop at once, without a ramp, loses no steps at 10 mm/s."""
_ROUNDING_MM = 0.006
"""Half a digit of the places in `M114`, and a margin."""
_NUMBER = r"\s*(-?\d+(?:\.\d+)?)"
_XYZ = rf"X:?{_NUMBER}\s+Y:?{_NUMBER}\s+Z:?{_NUMBER}"
_PLACE = re.compile(rf"{_XYZ}.*Count {_XYZ}")
_STEPS = re.compile(rf"(?:echo:)?\s*M92 {_XYZ}.*")
_SOFT = re.compile(
    rf"(?:echo:)?\s*Soft endstops: (ON|OFF)\s+Min:\s*{_XYZ}\s+Max:\s*{_XYZ}\s*", re.I
)
_SWITCH = re.compile(r"([xyz]_(?:min|max)|z_probe): .*", re.I)
_CAPABILITY = re.compile(r"Cap:(\w+):(\d)")
_REFUSALS = (
    "echo:Unknown command",
    "echo:Home ",
    "Error:checksum",
    "Error:No ",
    "Error:Line Number",
)
_WORD = re.compile(r"([GXYZF])(-?\d+(?:\.\d+)?)")


@dataclass
class MarlinSpeech:
    """Bytes to replies, lines in Grbl's words to numbered lines; remembers steps, motion mode and number.

    `ok` behind a report or a mark is not handed on: nobody waits for it.
    """

    _rest: bytes = b""
    _steps: Float[np.ndarray, "3"] | None = None
    _unasked: int = 0
    _number: int = 0
    _mode: str = "0"
    _feed: str = ""

    @property
    def status(self) -> bytes:
        """Return the question for the state, and first the one for the steps."""
        return b"M92\n" if self._steps is None else b"M114\n"

    def restart(self) -> None:
        """Count lines from 1 again, and wait for no `ok` any more."""
        self._number = self._unasked = 0

    def encode(self, line: str) -> bytes:
        """Return a numbered line with its check sum, whose moves name their speed: Marlin has one for all."""
        if line.startswith(("G53", "G0", "G1")):
            words = _WORD.findall(line.removeprefix("G53"))
            given = dict(words)
            self._mode, self._feed = given.get("G", self._mode), given.get("F", self._feed)
            feed = _RAPID_MM_MIN if self._mode == "0" else self._feed
            places = "".join(letter + value for letter, value in words if letter in "XYZ")
            line = f"G{self._mode}{places}F{feed}"
        self._number += 1
        text = f"N{self._number} {line}"
        # Exclusive or of all bytes before the star.
        return f"{text}*{np.bitwise_xor.reduce(list(text.encode()))}\n".encode()

    def feed(self, data: bytes) -> list[Reply]:
        """Replies that `data` completes; remarks are skipped."""
        *lines, self._rest = (self._rest + data).split(b"\n")
        texts = [line.decode("ascii", "replace").strip() for line in lines]
        return [reply for text in texts for reply in self._replies(text)]

    def _replies(self, text: str) -> list[Reply]:
        if text.startswith("ok"):
            is_unasked = self._unasked > 0
            self._unasked -= is_unasked
            return [] if is_unasked else [Done()]
        if match := _PLACE.match(text):
            self._unasked += 1
            return self._state(*np.reshape([float(number) for number in match.groups()], (2, 3)))
        if match := _STEPS.fullmatch(text):
            self._unasked += 1
            self._steps = np.array([float(number) for number in match.groups()])
            return []
        if text.removeprefix("echo:") == MARK.decode():
            self._unasked += 1
            return [Greeting()]
        return _remark(text)

    def _state(
        self, sent_mm: Float[np.ndarray, "3"], counts: Float[np.ndarray, "3"]
    ) -> list[Reply]:
        """Place of the motors, and whether the tip is sent to it."""
        if self._steps is None:
            return []
        x, y, z = (counts / self._steps).tolist()
        # Half a step and the digits of the report are no way left to go.
        allowed_mm = 0.5 / self._steps + _ROUNDING_MM
        arrived = (np.abs(sent_mm - counts / self._steps) <= allowed_mm).all()
        return [State("Idle" if arrived else "Run", None, (x, y, z))]


def _remark(text: str) -> list[Reply]:
    """Replies in what comes without a question, or belongs to the limits."""
    if text == "start":
        return [Greeting(restarted=True)]
    if text.startswith(_REFUSALS):
        return [Refused(text.removeprefix("echo:"))]
    if text.startswith(("Error:", "!!", "echo:endstops hit")):
        return [Alarm(text)]
    if match := _CAPABILITY.fullmatch(text):
        return [Setting(match[1], float(match[2]))]
    if match := _SWITCH.fullmatch(text):
        return [Setting(match[1].lower(), 1.0)]
    if match := _SOFT.fullmatch(text):
        names = [f"{axis} {end}" for end in ("min", "max") for axis in "XYZ"]
        ends = map(float, match.groups()[1:])
        return [Setting("soft", float(match[1].upper() == "ON")), *map(Setting, names, ends)]
    return []


def marlin_travel(settings: Mapping[str, float]) -> Travel:
    """Room of a machine by its soft limits.

    Raises
    ------
    InputError
        It cannot be stopped at once, has no soft limits, or homes Z downwards.
    """
    if settings.get("EMERGENCY_PARSER") != 1:
        raise InputError(
            "this Marlin was built without EMERGENCY_PARSER: a stop would wait behind the move that it is "
            "to stop. Build it with that option"
        )
    if settings.get("soft") != 1:
        raise InputError("its soft limits are off or it did not tell them. Send it M211 S1")
    if "z_max" not in settings or {"z_min", "z_probe"} & set(settings):
        raise InputError(
            "its Z axis homes downwards, onto the object (M119 names z_min or a probe, or no z_max). "
            "Home it at the upper end: a switch there and Z_HOME_DIR 1"
        )
    low, high = (tuple(settings[f"{axis} {end}"] for axis in "XYZ") for end in ("min", "max"))
    return Travel(low, high, high[2])
