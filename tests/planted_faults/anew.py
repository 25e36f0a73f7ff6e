"""Chosen tests in a process that imports the code anew, to the first that fails."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest

from tests.planted_faults.notes import Notes, processor_s, run

ARGUMENTS = ["-q", "-s", "-p", "no:cacheprovider", "-p", "no:xdist"]


class Imported:
    """Plugin that runs the chosen tests in their order."""

    def __init__(self, tests: list[str], notes: Notes) -> None:
        self.ranks = {test: rank for rank, test in enumerate(tests)}
        self.notes = notes

    def pytest_collectreport(self, report: pytest.CollectReport) -> None:
        if report.failed:
            self.notes.test = report.nodeid
            self.notes.says("fails")

    def pytest_runtestloop(self, session: pytest.Session) -> bool:
        chosen = [item for item in session.items if item.nodeid in self.ranks]
        self.notes.most_s += processor_s()  # imports are not of the tests
        if not self.notes.test:
            run(sorted(chosen, key=lambda item: self.ranks[item.nodeid]), self.notes)
        return True


def main() -> None:
    """Of the tests named in a folder's `tests.json`; notes go there too."""
    folder, most_s = Path(sys.argv[1]), float(sys.argv[2])
    tests = json.loads((folder / "tests.json").read_text(encoding="utf-8"))
    notes = Notes(folder / "notes", most_s)
    files = dict.fromkeys(test.split("::")[0] for test in tests)
    code = pytest.main([*ARGUMENTS, *files], plugins=[Imported(tests, notes)])
    if code not in (0, 5):
        notes.says("fails")
    notes.says("ends")


if __name__ == "__main__":
    main()
