"""Copies of the checkout in which a fault is planted and tests run."""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from tests.planted_faults.sites import Fault

SHARES = (0.1, 0.3, 0.6)
"""Of the time for a fault: the likeliest tests first, by themselves."""
SLOWER = 4.0
LEAST_S = 120.0
"""Tests that take so many times as long as without the fault hang: that is noticed too."""
NOTICED = ("noticed", "hangs")


class OutOfTime(Exception):
    """The call's time is over; the fault in work is judged by the next call."""


@dataclass(frozen=True)
class Clock:
    """`most_s` of tests for each fault, timed without it; `end`: no test runs after it (monotonic s)."""

    most_s: float
    end: float = float("inf")


@dataclass(frozen=True)
class Copy:
    """A checkout of its own; `sound` keeps which tests pass by themselves without a fault."""

    root: Path
    clock: Clock
    sound: dict[str, bool] = field(default_factory=dict)

    @classmethod
    def made(cls, source: Path, root: Path, clock: Clock) -> Copy:
        shutil.rmtree(root, ignore_errors=True)
        for name in sources(source):
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(source / name, root / name)
        return cls(root, clock)

    def judged(self, fault: Fault, tests: list[str], seconds: dict[str, float]) -> dict[str, Any]:
        """The outcome: noticed, hangs, or not noticed, by which test, and of how many tests.

        A test that fails by itself without the fault too, since it needs what others made before, is
        left out.
        """
        began = time.monotonic()
        asked: list[str] = []
        outcome, by = "not noticed", ""
        for batch in batches(tests, seconds, self.clock.most_s):
            while batch:
                outcome, by = self._run(batch, seconds, fault)
                if outcome != "noticed" or self._sound(by, seconds):
                    break
                batch = [test for test in batch if test != by]
                outcome, by = "not noticed", ""
            asked += batch
            if outcome in NOTICED:
                break
        took_s = round(time.monotonic() - began, 1)
        return {"outcome": outcome, "by": by, "of": len(asked), "seconds": took_s}

    def _sound(self, test: str, seconds: dict[str, float]) -> bool:
        if test not in self.sound:
            self.sound[test] = self._run([test], seconds, None)[0] == "not noticed"
        return self.sound[test]

    def _run(
        self, tests: list[str], seconds: dict[str, float], fault: Fault | None
    ) -> tuple[str, str]:
        if not tests:
            return "not noticed", ""
        limit_s = LEAST_S + SLOWER * sum(seconds.get(test, 0.0) for test in tests)
        left_s = self.clock.end - time.monotonic()
        try:
            with _planted(self.root, fault):
                code, said = run_tests(self.root, tests, min(limit_s, left_s))
        except subprocess.TimeoutExpired:
            if left_s < limit_s:
                raise OutOfTime from None
            return "hangs", tests[0]
        if code in (0, 5):
            return "not noticed", ""
        gone = [test for test in tests if f"not found: {self.root / test}\n" in said]
        if code == 4 and gone:  # names hold values that the fault changed
            return self._run([test for test in tests if test not in gone], seconds, fault)
        return "noticed", failed(said, tests)


def run_tests(root: Path, tests: list[str], limit_s: float) -> tuple[int, str]:
    """Exit code and output of pytest, which stops at the first that fails.

    Raises
    ------
    subprocess.TimeoutExpired
        It took too long; it was ended with all that it had started.
    """
    scratch = root.with_name(f"{root.name}_tmp")
    scratch.mkdir(exist_ok=True)
    command = [sys.executable, "-m", "pytest", "-x", "-q", "-p", "no:cacheprovider", *tests]
    child = subprocess.Popen(
        command,
        cwd=root,
        env=environment(root) | {"TMPDIR": str(scratch)},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        errors="replace",
        start_new_session=True,
    )
    try:
        said, _ = child.communicate(timeout=max(limit_s, 0.0))
        return child.returncode, said
    finally:
        with suppress(ProcessLookupError):
            os.killpg(child.pid, signal.SIGKILL)
        child.wait()
        shutil.rmtree(scratch, ignore_errors=True)


def failed(said: str, tests: list[str]) -> str:
    """The test that failed, as pytest says; the first where none could be collected."""
    for line in said.splitlines():
        kind, _, rest = line.partition(" ")
        named = [test for test in tests if rest == test or rest.startswith(f"{test} - ")]
        if kind in ("FAILED", "ERROR") and named:
            return max(named, key=len)
    return tests[0]


@contextmanager
def _planted(root: Path, fault: Fault | None) -> Iterator[None]:
    """Compiled code of the file is removed: it tells versions by their second and size."""
    if fault is None:
        yield
        return
    target = root / fault.path
    source = target.read_text(encoding="utf-8")
    try:
        target.write_text(fault.planted_in(source), encoding="utf-8")
        _forget(target)
        yield
    finally:
        target.write_text(source, encoding="utf-8")
        _forget(target)


def _forget(target: Path) -> None:
    for compiled in (target.parent / "__pycache__").glob(f"{target.stem}.*"):
        compiled.unlink(missing_ok=True)


def batches(tests: list[str], seconds: dict[str, float], most_s: float) -> list[list[str]]:
    """Tests in order, for shares of the time; those that do not fit any more are left out.

    The first goes however long it takes.
    """
    found: list[list[str]] = [[]]
    spent = 0.0
    bounds = iter(SHARES)
    share = next(bounds) * most_s
    for test in tests:
        took = seconds.get(test, 0.0)
        if spent + took > most_s and spent:
            continue
        if spent + took > share and found[-1]:
            share += next(bounds, 0.0) * most_s
            found.append([])
        found[-1].append(test)
        spent += took
    return [batch for batch in found if batch]


def environment(root: Path) -> dict[str, str]:
    """For tests of a checkout: its code first, one thread each."""
    threads = dict.fromkeys(("OMP_NUM_THREADS", "MKL_NUM_THREADS", "OPENBLAS_NUM_THREADS"), "1")
    paths = [str(root), *filter(None, [os.environ.get("PYTHONPATH")])]
    return os.environ | threads | {"PYTHONPATH": os.pathsep.join(paths)}


def sources(root: Path) -> list[str]:
    """Files of a checkout, by git; without it, all but hidden folders, installed packages and results."""
    if (root / ".git").exists():
        listed = subprocess.run(
            ["git", "ls-files", "-z"], cwd=root, capture_output=True, text=True, check=True
        )
        return [name for name in listed.stdout.split("\0") if name]
    packages = {Path(folder).resolve() for folder in sys.path} - {root.resolve()}
    found = []
    for folder, inner, files in os.walk(root):
        inner[:] = [
            name
            for name in inner
            if name != "__pycache__"
            and not name.startswith(".")
            and (Path(folder) / name).resolve() not in packages
            and not (Path(folder) / name / "reach.json").exists()
        ]
        found += [(Path(folder) / name).relative_to(root).as_posix() for name in files]
    return found
