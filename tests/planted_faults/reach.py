"""Which test reaches which line of the code, and how long each takes."""

from __future__ import annotations

import json
import subprocess
import sys
import xml.etree.ElementTree
from collections import defaultdict
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from design.files import atomic_path
from tests.planted_faults.copies import environment
from tests.support.scheduling import room_of

MEASURED = ("design", "fem", "estimator", "instobj")


@dataclass(frozen=True)
class Reached:
    """Tests that run a line: themselves, or in the setup of fixtures that others may share."""

    run: frozenset[str] = frozenset()
    setup: frozenset[str] = frozenset()


@dataclass(frozen=True)
class Reach:
    """Of the tests that pass.

    Attributes
    ----------
    lines : file of the code → line → tests
    seconds : test → time
    failing : tests that fail without a fault
    """

    lines: dict[str, dict[int, Reached]]
    seconds: dict[str, float]
    failing: tuple[str, ...] = ()

    def tests_of(self, path: str, line: int) -> list[str]:
        """Tests that may notice a fault in a line, those that most likely do first.

        First those that run it, and all of a file in which a fixture does; then those of the same
        room that run others of the same module: what shared fixtures do is counted for one test
        alone. What runs as it is imported concerns all that run the module.
        """
        module = self.lines.get(path, {})
        reached = module.get(line, Reached())
        direct = reached.run | self._of_files({_file(test) for test in reached.setup})
        anyone = frozenset().union(*(one.run | one.setup for one in module.values()))
        near = f"{Path('tests', path).parent}/"
        rooms = room_of(near) or (near,)
        files = {file for file in map(_file, anyone) if f"{Path(file).parent}/" in rooms}
        found = (direct | self._of_files(files)) if direct else anyone | self._of_files(files)
        found -= set(self.failing)
        own = f"test_{Path(path).stem}.py"

        def rank(test: str) -> tuple[bool, bool, bool, float, str]:
            file = Path(_file(test))
            away = f"{file.parent}/" != near
            seconds = self.seconds.get(test, 0.0)
            return test not in direct, file.name != own or away, away, seconds, test

        return sorted(found, key=rank)

    def _of_files(self, files: set[str]) -> frozenset[str]:
        return frozenset(test for test in self.seconds if _file(test) in files)


def _file(test: str) -> str:
    return test.split("::")[0]


def reach(root: Path, folder: Path, processes: int) -> Reach:
    """Of the usual tests, from `folder`/reach.json, or by running them once under coverage.py."""
    kept = folder / "reach.json"
    if not kept.exists():
        found = _measured(root, folder, processes)
        with atomic_path(kept) as temporary:
            temporary.write_text(json.dumps(_content(found)), encoding="utf-8")
    found = _from_content(json.loads(kept.read_text(encoding="utf-8")))
    for test in found.failing:
        print(f"left out, as it fails without a fault: {test}", flush=True)
    return found


def _measured(root: Path, folder: Path, processes: int) -> Reach:
    data, times = folder / "coverage", folder / "times.xml"
    command = [sys.executable, "-m", "pytest", "-q", "-n", str(processes)]
    command += [f"--cov={package}" for package in MEASURED]
    command += ["--cov-context=test", "--cov-report=", f"--junitxml={times}", "tests"]
    times.unlink(missing_ok=True)
    subprocess.run(
        command, cwd=root, env=environment(root) | {"COVERAGE_FILE": str(data)}, check=False
    )
    if not (times.exists() and data.exists()):
        sys.exit("error: the usual tests could not be run (see above). Make `make test` run first")
    seconds, failing = _outcomes(times)
    if len(failing) > 0.1 * len(seconds):
        sys.exit(f"error: {len(failing)} of {len(seconds)} tests fail without a fault. Fix them")
    return Reach(_lines(root, data), seconds, failing)


def _lines(root: Path, data: Path) -> dict[str, dict[int, Reached]]:
    from coverage import CoverageData

    stored = CoverageData(str(data))
    stored.read()
    found: dict[str, dict[int, Reached]] = {}
    for file in stored.measured_files():
        path = Path(file).relative_to(root).as_posix()
        found[path] = {
            line: _reached([context for context in contexts if context])
            for line, contexts in stored.contexts_by_lineno(file).items()
        }
    return found


def _reached(contexts: list[str]) -> Reached:
    """Of contexts such as `tests/fem/test_a.py::test_b[1]|setup`."""
    by_phase: dict[str, set[str]] = defaultdict(set)
    for context in contexts:
        test, _, phase = context.rpartition("|")
        by_phase[phase].add(test)
    setup = frozenset(by_phase.pop("setup", ()))
    return Reached(frozenset().union(*by_phase.values()), setup)


def _outcomes(times: Path) -> tuple[dict[str, float], tuple[str, ...]]:
    """Time of each test, and those that failed."""
    seconds: dict[str, float] = {}
    failing = []
    for case in xml.etree.ElementTree.parse(times).iter("testcase"):
        file = case.get("classname", "").replace(".", "/") + ".py"
        test = f"{file}::{case.get('name', '')}"
        seconds[test] = float(case.get("time", 0))
        if case.find("failure") is not None or case.find("error") is not None:
            failing.append(test)
    return seconds, tuple(failing)


def _content(found: Reach) -> dict[str, Any]:
    """Tests by number, each set of them once: 30 000 lines share some thousand sets."""
    numbers = {test: number for number, test in enumerate(found.seconds)}
    sets: dict[tuple[tuple[int, ...], ...], int] = {}
    lines: dict[str, dict[str, int]] = {}
    for path, of_file in found.lines.items():
        lines[path] = {}
        for line, reached in of_file.items():
            phases = tuple(
                tuple(sorted(numbers[test] for test in tests if test in numbers))
                for tests in (reached.run, reached.setup)
            )
            lines[path][str(line)] = sets.setdefault(phases, len(sets))
    return {
        "seconds": found.seconds,
        "failing": found.failing,
        "sets": list(sets),
        "lines": lines,
    }


def _from_content(content: dict[str, Any]) -> Reach:
    tests = list(content["seconds"])
    sets = [
        Reached(*(frozenset(tests[number] for number in phase) for phase in phases))
        for phases in content["sets"]
    ]
    lines = {
        path: {int(line): sets[number] for line, number in of_file.items()}
        for path, of_file in content["lines"].items()
    }
    return Reach(lines, content["seconds"], tuple(content["failing"]))
