"""Which test file reaches which line of the code, and how long each file takes."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import xml.etree.ElementTree
from collections import defaultdict
from dataclasses import dataclass
from pathlib import Path

from design.files import atomic_path
from tests.support.scheduling import room_of


@dataclass(frozen=True)
class Reach:
    """`lines`: file of the code → line → test files; `seconds`: test file → time."""

    lines: dict[str, dict[int, frozenset[str]]]
    seconds: dict[str, float]

    def tests_of(self, path: str, line: int) -> list[str]:
        """Test files that may notice a fault in a line, those that most likely do first.

        Those that run the line, and those of the same room that run others of the same module: what
        runs as it is imported, and in shared fixtures, is counted for one file alone.
        """
        module = self.lines.get(path, {})
        direct = set(module.get(line, ()))
        near = f"{Path('tests', path).parent}/"
        rooms = room_of(near) or (near,)
        anyone = set().union(*module.values()) if module else set()
        found = direct | {test for test in anyone if f"{Path(test).parent}/" in rooms}
        if not direct:
            found = anyone
        own = f"test_{Path(path).stem}.py"

        def rank(test: str) -> tuple[bool, bool, float]:
            away = f"{Path(test).parent}/" != near
            return Path(test).name != own or away, away, self.seconds.get(test, 0.0)

        return sorted(found, key=rank)


def reach(root: Path, folder: Path) -> Reach:
    """Of the usual tests, from `folder`/reach.json, or by running them once under coverage.py."""
    kept = folder / "reach.json"
    if not kept.exists():
        data = folder / "coverage"
        times = folder / "times.xml"
        command = [sys.executable, "-m", "pytest", "-q", "-n", "2", "--dist", "loadfile"]
        command += [f"--cov={package}" for package in ("design", "fem", "estimator", "instobj")]
        command += ["--cov-context=test", "--cov-report=", f"--junitxml={times}", "tests"]
        threads = {"OMP_NUM_THREADS": "1", "MKL_NUM_THREADS": "1", "COVERAGE_FILE": str(data)}
        if subprocess.run(command, cwd=root, env=os.environ | threads).returncode:
            sys.exit("error: the usual tests fail without a fault (see above). Fix them first")
        found = Reach(_lines(root, data), _seconds(times))
        content = {
            "lines": {
                path: {str(line): sorted(tests) for line, tests in lines.items()}
                for path, lines in found.lines.items()
            },
            "seconds": found.seconds,
        }
        with atomic_path(kept) as temporary:
            temporary.write_text(json.dumps(content), encoding="utf-8")
    content = json.loads(kept.read_text(encoding="utf-8"))
    lines = {
        path: {int(line): frozenset(tests) for line, tests in of_file.items()}
        for path, of_file in content["lines"].items()
    }
    return Reach(lines, content["seconds"])


def _lines(root: Path, data: Path) -> dict[str, dict[int, frozenset[str]]]:
    from coverage import CoverageData

    stored = CoverageData(str(data))
    stored.read()
    found: dict[str, dict[int, frozenset[str]]] = {}
    for file in stored.measured_files():
        path = Path(file).relative_to(root).as_posix()
        tests: dict[int, set[str]] = defaultdict(set)
        for line, contexts in stored.contexts_by_lineno(file).items():
            tests[line] |= {context.split("::")[0] for context in contexts if context}
        found[path] = {line: frozenset(names) for line, names in tests.items()}
    return found


def _seconds(times: Path) -> dict[str, float]:
    seconds: dict[str, float] = defaultdict(float)
    for case in xml.etree.ElementTree.parse(times).iter("testcase"):
        name = case.get("classname", "").replace(".", "/") + ".py"
        seconds[name] += float(case.get("time", 0))
    return dict(seconds)
