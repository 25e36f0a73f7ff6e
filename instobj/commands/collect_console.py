"""What a user types while `instobj collect` runs, and Ctrl-C as the way to end it."""

from __future__ import annotations

import os
import select
import signal
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass


@dataclass
class TypedLines:
    """Lines from standard input (typed or piped), without ever waiting; POSIX systems only."""

    _rest: bytes = b""
    _open: bool = os.name == "posix"

    def poll(self) -> list[str]:
        """Lines that were completed since the last time."""
        if not self._open:
            return []
        try:
            handle = sys.stdin.fileno()
            if not select.select([handle], [], [], 0)[0]:
                return []
            data = os.read(handle, 4096)
        except (AttributeError, OSError, ValueError):
            data = b""
        self._open = bool(data)
        *lines, self._rest = (self._rest + data).split(b"\n")
        return [line.decode("utf-8", "replace").strip() for line in lines]


@contextmanager
def stop_on_signals(stop: Callable[[], None]) -> Iterator[None]:
    """Ctrl-C and SIGTERM call `stop` once; the next one acts as it did before."""
    numbers = (signal.SIGINT, signal.SIGTERM)
    before = {number: signal.getsignal(number) for number in numbers}

    def ask(number: int, _: object) -> None:
        stop()
        signal.signal(number, before[signal.Signals(number)])

    for number in numbers:
        signal.signal(number, ask)
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
