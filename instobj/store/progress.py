"""Progress of long work on standard error: a live line on a terminal, plain lines elsewhere."""

from __future__ import annotations

import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field

from rich.console import Console
from rich.status import Status


@dataclass
class ProgressLine:
    """What the stage at work is doing now; `step` is handed to the stages."""

    console: Console = field(default_factory=lambda: Console(stderr=True, highlight=False))
    _status: Status | None = None
    _title: str = ""
    _started: float = 0.0

    @contextmanager
    def stage(self, title: str) -> Iterator[None]:
        """Show `title` while the stage works; the live line is one, however stages lie in each other."""
        before = self._title, self._started
        self._title, self._started = title, time.perf_counter()
        try:
            if self._status is not None or not self.console.is_terminal:
                yield
                return
            with self.console.status(title) as self._status:
                try:
                    yield
                finally:
                    self._status = None
        finally:
            self._title, self._started = before

    def step(self, message: str) -> None:
        """Say what is being done within the stage."""
        elapsed = time.perf_counter() - self._started
        line = f"{self._title}: {message} [dim]({elapsed:.0f} s)[/dim]" if self._title else message
        if self._status is not None:
            self._status.update(line)
        else:
            self.console.print(f"  … {line}", soft_wrap=True)  # a log has no columns to break at
            sys.stderr.flush()

    def say(self, message: str) -> None:
        """A line that stays."""
        self.console.print(message)
