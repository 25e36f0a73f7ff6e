"""What a fork that runs tests tells its parent, in a file, so that nothing is lost when it dies."""

from __future__ import annotations

import json
import os
import resource
import signal
import time
from dataclasses import dataclass, field
from pathlib import Path

import pytest
from _pytest.runner import runtestprotocol

from tests.support import typechecks

HANGS_S = 120
"""Processor time of one test; the usual tests hold none that takes half of it."""
WAITS_S = 1800.0
"""Time in which a fork says nothing."""


@dataclass
class Notes:
    """One line for each event."""

    file: Path
    most_s: float
    test: str = ""

    def begins(self, test: str) -> None:
        self.test = test
        self.says("begins")
        limit = int(time.process_time()) + HANGS_S
        resource.setrlimit(resource.RLIMIT_CPU, (limit, resource.getrlimit(resource.RLIMIT_CPU)[1]))

    def says(self, event: str) -> None:
        with self.file.open("a", encoding="utf-8") as stream:
            stream.write(json.dumps([event, self.test, round(processor_s(), 2)]) + "\n")

    def passes(self) -> None:
        """With the functions that the test called, of which the parent learns whom to ask first."""
        self.says("passes")
        with self.file.with_name("calls").open("a", encoding="utf-8") as stream:
            stream.write(json.dumps([self.test, sorted(typechecks.called_in_test())]) + "\n")

    def over(self) -> bool:
        return processor_s() > self.most_s


@dataclass(frozen=True)
class Said:
    """What a fork told; `died`: `hangs` or `dies`, where it did not come to its end."""

    events: list[tuple[str, str, float]]
    died: str = ""
    calls: dict[str, set[tuple[str, str]]] = field(default_factory=dict)

    @property
    def failed(self) -> str | None:
        """The test that failed, or in which the fork died; empty before the first."""
        for event, test, _ in self.events:
            if event == "fails":
                return test
        return (self.events[-1][1] if self.events else "") if self.died else None

    def has(self, event: str) -> bool:
        return any(one == event for one, _, _ in self.events)

    @property
    def spent_s(self) -> float:
        return self.events[-1][2] if self.events else 0.0

    def seconds(self) -> dict[str, float]:
        """Processor time of each test that passed."""
        began = {test: at for event, test, at in self.events if event == "begins"}
        return {test: at - began[test] for event, test, at in self.events if event == "passes"}


def run(items: list[pytest.Item], notes: Notes) -> None:
    for item, following in zip(items, [*items, None][1:], strict=True):
        if notes.over():
            return
        notes.begins(item.nodeid)
        reports = runtestprotocol(item, log=False, nextitem=following)
        if any(report.failed for report in reports):
            return notes.says("fails")
        notes.passes()


def processor_s() -> float:
    return sum(os.times()[:4])


def ended(child: int, file: Path) -> str:
    """Wait for a fork: `hangs` where it ran out of processor time or said nothing, else `dies`."""
    size, since = -1, time.monotonic()
    while True:
        done, status = os.waitpid(child, os.WNOHANG)
        if done:
            out = os.WIFSIGNALED(status) and os.WTERMSIG(status) == signal.SIGXCPU
            return "hangs" if out else "dies"
        now = file.stat().st_size if file.exists() else 0
        if now != size:
            size, since = now, time.monotonic()
        if time.monotonic() - since > WAITS_S:
            os.kill(child, signal.SIGKILL)
            os.waitpid(child, 0)
            return "hangs"
        time.sleep(0.02)
