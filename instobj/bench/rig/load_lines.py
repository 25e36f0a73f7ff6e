"""Load cells on a port: lines of boards (`L`), or one number per line."""

from __future__ import annotations

import re
from collections.abc import Generator, Iterator
from dataclasses import dataclass

from design.errors import InputError
from estimator.recordings.boards.lines import LineDecoder, Load
from estimator.recordings.boards.link import serial_chunks

_NUMBER = re.compile(r"\s*([-+]?\d+(?:\.\d*)?(?:[eE][-+]?\d+)?)\s*(N|mN|g|kg)?\s*")
_NEWTON_PER = {"N": 1.0, "mN": 1e-3, "g": 9.80665e-3, "kg": 9.80665}
_ENDS = {float(end) for bits in (15, 16, 23, 24, 31, 32) for end in (2**bits - 1, -(2**bits))}
"""Ends of signed and unsigned integers of 16, 24 and 32 bits; one sound number in 30 000 may be one."""


@dataclass
class NumberLines:
    """One number per line, with or without unit (N, mN, g, kg); `scale` makes it newtons without one."""

    scale: float
    damaged: int = 0
    _rest: bytes = b""
    _started: bool = False

    def feed(self, data: bytes) -> list[float]:
        """Forces (N) that `data` completes; the first line may be half of one and is left out."""
        *lines, self._rest = (self._rest + data).split(b"\n")
        if lines and not self._started:
            self._started = True
            lines = lines[1:]
        forces_n = []
        for line in lines:
            match = _NUMBER.fullmatch(line.decode("ascii", "replace"))
            if match:
                forces_n.append(self._force_n(float(match[1]), match[2]))
            elif line.strip():
                self.damaged += 1
        return forces_n

    def _force_n(self, value: float, unit: str | None) -> float:
        """NaN at the end of an integer scale, which is what amplifiers say that saturate or fail."""
        if unit:
            return value * _NEWTON_PER[unit]
        return float("nan") if value in _ENDS else value * self.scale


def forces_on(port: str, baud: int, scale: float | None) -> Generator[list[float]]:
    """Forces (N) that a port has said since the last time; without waiting.

    `scale` None: lines `L`; else newtons per unit of a number per line, negative where pressing makes
    the number smaller.
    """
    chunks: Iterator[bytes] = serial_chunks(port, baud, timeout_s=0.0)
    if scale == 0:
        raise InputError(
            "--load-port PORT=0 has no force. Give newtons per unit of the numbers sent"
        )
    decoder = LineDecoder() if scale is None else NumberLines(scale)
    for chunk in chunks:
        if isinstance(decoder, NumberLines):
            yield decoder.feed(chunk)
        else:
            loads = (
                message
                for message in decoder.feed(chunk)
                if isinstance(message, Load) and message.cell == 1
            )
            yield [load.force_n for load in loads]
