"""A process that has imported and collected all tests once, and forks for every fault.

Before the first it learns, in a fork for every test file of the faults' packages, what tests call.

A fault inside a function is put into the fork's memory (`swapping`); what acts as modules are
imported (constants, defaults, functions that these call) is imported by a fresh process (`anew`). The
file holds the fault meanwhile. Time is the fork's processor time.
"""

from __future__ import annotations

import ast
import json
import os
import re
import shutil
import signal
import sys
import tempfile
import time
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path
from typing import Any

import pytest

from design.files import atomic_path
from tests.planted_faults.__main__ import identity, lines, said
from tests.planted_faults.anew import ARGUMENTS
from tests.planted_faults.nearness import importers, nearest, room_of
from tests.planted_faults.notes import Notes, Said, ended, run
from tests.planted_faults.sites import Fault
from tests.planted_faults.swapping import function_of, swap
from tests.support import typechecks

Function = tuple[str, str]
"""Module and name."""

FIRST_S = 6.0
"""Of tests for each fault before any gets more: most are noticed, and it is learned what tests call."""
LONG_S = 5.0
"""Of a test that then goes after the others."""
READ = {
    "truth": re.compile(r"tests/chain/test_guards\.py"),
}
"""Tests of what stands in the code, which call none of it, by the kind of faults that they notice."""
LEARNT_S = 6.0
"""Of a test file that runs without a fault first."""
NEAR_FILES = 8
"""Test files that a fresh process imports first: to import all that a fault may reach takes a minute."""


@dataclass(frozen=True)
class Clock:
    """`most_s` of tests for each fault; no test begins after `end` (seconds since 1970)."""

    most_s: float = 150.0
    end: float = float("inf")


@dataclass
class Server:
    """Plugin that judges faults in place of running the tests; `told` takes each outcome."""

    root: Path
    faults: Iterable[Fault]
    told: Callable[[dict[str, Any]], None]
    clock: Clock = Clock()
    learnt: Path | None = None
    seconds: dict[str, float] = field(default_factory=dict)
    calls: dict[str, set[Function]] = field(default_factory=dict)
    sound: dict[tuple[str, bool], bool] = field(default_factory=dict)

    def pytest_runtestloop(self, session: pytest.Session) -> bool:
        self.items = {item.nodeid: item for item in session.items}
        left, imported_by = list(self.faults), importers(self.root)
        typechecks.build_all()
        self.learn({fault.path.split("/")[0] for fault in left})
        rounds = sorted({min(FIRST_S, self.clock.most_s), self.clock.most_s})
        for most_s in rounds:
            kept = []
            for fault in left:
                if time.time() > self.clock.end:
                    return True
                tests = nearest(fault.path, list(self.items), imported_by)
                outcome = asdict(fault) | self.judged(fault, tests, most_s)
                if outcome["by"] or most_s == rounds[-1]:
                    self.told(outcome)
                else:
                    kept.append(fault)
                    print(f"still to judge: {said(self.root, outcome)}", flush=True)
            left = kept
        return True

    def learn(self, packages: set[str]) -> None:
        """What tests of the packages call, and how long they take: each file's first ones, without a
        fault. What stands in the file `learnt` is known; a later call goes on with the others."""
        known = {one["test"]: one for one in lines(self.learnt)} if self.learnt else {}
        files: dict[str, list[str]] = {}
        for test in self.items:
            if test not in known and any(test.startswith(f"tests/{name}/") for name in packages):
                files.setdefault(test.split("::")[0], []).append(test)
        for tests in files.values():
            said = self.in_fork(None, tests, anew=False, most_s=LEARNT_S)
            failed = [] if said.failed is None else [said.failed or tests[0]]
            took_s = said.seconds() | dict.fromkeys(failed, LEARNT_S)
            for test in took_s:
                calls = sorted(said.calls[test]) if test in said.calls else None
                known[test] = {"test": test, "seconds": took_s[test], "calls": calls}
        for test, one in known.items():
            self.seconds[test] = one["seconds"]
            if one["calls"] is not None:
                self.calls[test] = {(module, name) for module, name in one["calls"]}
        if self.learnt is not None and files:
            with atomic_path(self.learnt) as temporary:
                text = "".join(f"{json.dumps(one)}\n" for one in known.values())
                temporary.write_text(text, "utf-8")

    def judged(self, fault: Fault, tests: list[str], most_s: float) -> dict[str, Any]:
        """Outcome (noticed, hangs, not noticed, not reached), by which test, and of how many.

        A test that fails by itself without the fault is left out.
        """
        anew = acts_at_import(self.root, fault)
        function, room = None if anew else holding(self.root, fault), room_of(fault.path, tests)
        left = in_order(tests, function, room, self.seconds, self.calls, READ.get(fault.kind))
        by, asked, spent_s, reached, hangs = "", 0, 0.0, anew and bool(tests), False
        while left and not by and spent_s < most_s:
            batch = _of_near_files(left) if anew else left
            with planted(self.root, fault):
                said = self.in_fork(fault, batch, anew, most_s - spent_s)
            if said.has("in no function"):
                anew, reached = True, True
                continue
            spent_s += said.spent_s
            self.seconds |= said.seconds()
            self.calls |= said.calls
            asked += sum(event == "begins" for event, _, _ in said.events)
            reached = reached or said.has("reached")
            if said.failed is None:
                left = left[len(batch) :]
            elif self._sound(said.failed or left[0], anew):
                by, hangs = said.failed or left[0], said.died == "hangs"
            else:
                left = [test for test in left if test != (said.failed or left[0])]
        told = "not noticed" if reached else "not reached"
        outcome = ("hangs" if hangs else "noticed") if by else told
        return {"outcome": outcome, "by": by, "of": asked, "seconds": round(spent_s, 2)}

    def _sound(self, test: str, anew: bool) -> bool:
        if (test, anew) not in self.sound:
            self.sound[test, anew] = (
                self.in_fork(None, [test], anew, self.clock.most_s).failed is None
            )
        return self.sound[test, anew]

    def in_fork(self, fault: Fault | None, tests: list[str], anew: bool, most_s: float) -> Said:
        scratch = Path(tempfile.mkdtemp(prefix="planted_"))
        notes = Notes(scratch / "notes", most_s)
        child = os.fork()
        if not child:
            try:
                self._child(fault, tests, anew, notes, scratch)
                notes.says("ends")
            finally:
                os._exit(0)
        try:
            died = ended(child, notes.file)
            lines = notes.file.read_text("utf-8").splitlines() if notes.file.exists() else []
            said = Said(
                [tuple(json.loads(line)) for line in lines], calls=_calls(scratch / "calls")
            )
            return said if said.has("ends") else replace(said, died=died)
        finally:
            with suppress(ProcessLookupError):
                os.killpg(child, signal.SIGKILL)
            shutil.rmtree(scratch, ignore_errors=True)

    def _child(
        self, fault: Fault | None, tests: list[str], anew: bool, notes: Notes, scratch: Path
    ) -> None:
        os.setpgrp()
        for stream in (0, 1, 2):
            os.dup2(os.open(os.devnull, os.O_RDWR), stream)
        (scratch / "shared").mkdir()
        os.environ |= {"TMPDIR": str(scratch), "INSTOBJ_TESTS_SHARED": str(scratch / "shared")}
        tempfile.tempdir = None
        if anew:
            (scratch / "tests.json").write_text(json.dumps(tests), encoding="utf-8")
            module = ["-m", "tests.planted_faults.anew", str(scratch), str(notes.most_s)]
            os.execv(sys.executable, [sys.executable, *module])  # noqa: S606
        if fault is None or swap(self.root, fault, lambda: notes.says("reached")):
            run([self.items[test] for test in tests], notes)
        else:
            notes.says("in no function")


def in_order(
    tests: list[str],
    function: Function | None,
    room: Path | None,
    seconds: dict[str, float],
    calls: dict[str, set[Function]],
    read: re.Pattern[str] | None = None,
) -> list[str]:
    """Those of a pattern; tests of the room that called the function when they ran before, then others
    that did, the quickest first; those that are not known, and last those that did not.
    """

    def rank(test: str) -> tuple[int, float]:
        took_s, called = seconds.get(test, 0.0), calls.get(test)
        if read and read.match(test):
            return 0, 0.0
        if function is None or called is None:
            return 3, float(took_s > LONG_S)
        if function not in called:
            return 4, float(took_s > LONG_S)
        return 1 + (Path(test.split("::")[0]).parent != room), took_s

    return sorted(tests, key=rank)


def _of_near_files(tests: list[str]) -> list[str]:
    """The first tests of a list, up to those of the file after `NEAR_FILES`."""
    files: set[str] = set()
    for number, test in enumerate(tests):
        files.add(test.split("::")[0])
        if len(files) > NEAR_FILES:
            return tests[:number]
    return tests


def _calls(file: Path) -> dict[str, set[Function]]:
    """Functions that each test called; the last line may be cut."""
    text = file.read_text(encoding="utf-8") if file.exists() else ""
    told = [json.loads(line) for line in text.splitlines() if line.endswith("]]]")]
    return {test: {(module, name) for module, name in names} for test, names in told}


def holding(root: Path, fault: Fault) -> Function | None:
    """Module and name of the function that holds a fault."""
    found = function_of(ast.parse((root / fault.path).read_text(encoding="utf-8")), fault.line)
    return found and (fault.path.removesuffix(".py").replace("/", "."), found[0])


def acts_at_import(root: Path, fault: Fault) -> bool:
    """Whether a fault is in no function, or in one that was called as modules were imported."""
    function = holding(root, fault)
    return function is None or function in typechecks.called()


@contextmanager
def planted(root: Path, fault: Fault) -> Iterator[None]:
    """Compiled code of the file is removed: it tells versions by their second and size."""
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


def main() -> None:
    """Judge every `parts`-th fault of a folder that has no outcome yet."""
    folder, part, parts, most_s = Path(sys.argv[1]), *map(float, sys.argv[2:5])
    end = time.time() + 60 * float(sys.argv[5]) if len(sys.argv) > 5 else float("inf")
    file = folder / "outcomes.jsonl"
    done = {identity(one) for one in lines(file)}
    mine = lines(folder / "faults.jsonl")[int(part) :: int(parts)]
    left = [Fault(**one) for one in mine if identity(one) not in done]

    def told(outcome: dict[str, Any]) -> None:
        with file.open("a", encoding="utf-8") as stream:
            stream.write(json.dumps(outcome) + "\n")
        print(said(server.root, outcome), flush=True)

    server = Server(Path.cwd(), left, told, Clock(most_s, end), folder / "learnt.jsonl")
    sys.exit(pytest.main([*ARGUMENTS, "tests"], plugins=[server]))


if __name__ == "__main__":
    main()
