"""Progress of long work on standard error: a live bar on a terminal, a line a stage elsewhere."""

from __future__ import annotations

import sys
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, nullcontext
from dataclasses import dataclass, field
from threading import Event, Thread

from rich.console import Console

from instobj.store.run_bar import RunBar

NEWS_EVERY_S = 4.0
"""For code that has news all the time."""
MOST_SILENT_S = 5.0
"""Longest time between two looks whether a log needs a line, s."""
LOG_EVERY_S = 300.0
"""Longest time between two lines of a log, s: a log is read afterwards, not watched."""
MOST_NEWS = 6
"""Lines about stages at work that a log gets before they come once in `LOG_EVERY_S` alone."""
_shown = Event()


def show_progress() -> None:
    """Let this process tell its progress, as the command line does; a library is silent."""
    _shown.set()


@dataclass
class ProgressLine:
    """Line that shows what the stage at work is doing now; `step` is handed to the stages.

    On a terminal a bar shows the step and its time. A log names a stage once it has lasted 5 s, and its
    step after twice the time each, 5 min at most; so too where the stage is silent.
    """

    console: Console = field(
        default_factory=lambda: Console(stderr=True, highlight=False, quiet=not _shown.is_set())
    )
    bar: RunBar | None = None
    _title: str = ""
    _step: str = ""
    _started: float = 0.0
    _told: float = 0.0
    _logged: float = field(default_factory=time.perf_counter)
    _wait_s: float = 0.0
    _news: int = 0

    @property
    def watched(self) -> bool:
        """True where lines go to a terminal and are not silenced."""
        return self.console.is_terminal and not self.console.quiet

    @contextmanager
    def whole_run(self, due: Sequence[tuple[str, float]]) -> Iterator[None]:
        """Show one bar for the stages `due` (title, expected seconds) where someone watches."""
        if not self.watched:
            yield
            return
        with RunBar(self.console, due) as self.bar:
            try:
                yield
            finally:
                self.bar = None

    @contextmanager
    def stage(self, title: str) -> Iterator[None]:
        """Show `title` while the stage works; the bar is one, however stages lie in each other."""
        outer = self._title, self._step, self._started
        self._title, self._step = title, ""
        self._started = self._told = time.perf_counter()
        try:
            if outer[0]:
                yield
                return
            self._wait_s = MOST_SILENT_S if self._news < MOST_NEWS else LOG_EVERY_S
            with self._live(title), self._reminder():
                yield
        finally:
            self._title, self._step, self._started = outer

    def step(self, message: str) -> None:
        """Say what is being done within the stage."""
        self._step, self._told = message, time.perf_counter()
        title = ": ".join(filter(None, (self._title, message)))
        elapsed = self._told - self._started
        line = f"{title} [dim]({elapsed:.0f} s)[/dim]" if self._title else message
        if self.bar is not None:
            self.bar.show(title)
        elif self._is_due():
            self._wait_s, self._news = 2 * self._wait_s, self._news + 1
            self._log(f"  … {line}")

    def _is_due(self) -> bool:
        """Return whether a log needs a line about the stage at work."""
        waited_s = self._told - max(self._logged, self._started)
        in_stage = bool(self._title) and waited_s >= self._wait_s
        return in_stage or self._told - self._logged >= LOG_EVERY_S

    def say(self, message: str) -> None:
        """A line that stays."""
        self._told = time.perf_counter()
        if self.console.is_terminal:
            self.console.print(message)
        else:
            self._log(message)

    def _log(self, line: str) -> None:
        """Write a line of a log, which has no columns to break at."""
        self._logged = time.perf_counter()
        self.console.print(line, soft_wrap=True)
        sys.stderr.flush()

    @contextmanager
    def _live(self, title: str) -> Iterator[None]:
        """Show the stage in the run's bar, or in one of its own."""
        with nullcontext() if self.bar is not None else self.whole_run([]):
            if self.bar is not None:
                self.bar.begin(title)
            yield

    @contextmanager
    def _reminder(self) -> Iterator[None]:
        """Write the last step again wherever a log got no line for a while."""
        if self.bar is not None:  # it shows the time by itself
            yield
            return
        ended = Event()

        def remind() -> None:
            while not ended.wait(max(0.0, self._told + MOST_SILENT_S - time.perf_counter())):
                if time.perf_counter() - self._told >= MOST_SILENT_S:
                    self.step(self._step)

        thread = Thread(target=remind, name="reminder", daemon=True)
        thread.start()
        try:
            yield
        finally:
            ended.set()
            thread.join()
