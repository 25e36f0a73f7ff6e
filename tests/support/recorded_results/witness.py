"""Compares what functions return in the tests with the record, or writes down what they return.

Functions of `design`, `fem` and `estimator` go through `Witness.call` in their first calls of a test
(`tests.support.typechecks`). If the record of that test file holds the arguments, the result must be
what it was, to a millionth (rough ones to a thousandth). Arguments that the record does not hold say
nothing, so tests may change as they like.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

from tests.support.recorded_results.digests import Opaque, of_arguments, of_result

FOLDER = Path(__file__).parents[2] / "references" / "results"
SHARE, ROUGH_SHARE = 1e-6, 1e-3
LEAST = 1e-12
"""Sums may differ by this share of Σ|v| (the second where keys end with `ROUGH`), and by this much."""
ROUGH = "~"
"""After the key of a result in single precision, or that is else not the same on every processor."""
MOST_TRIES = 12
"""Calls of one function that are looked up in one test file."""

Result = list[Any]
"""Checksum, then size, Σ|v| and Σ v cos(…) of each part."""
Records = dict[str, dict[str, dict[str, Any]]]
"""By test file, function and key of arguments."""


class Witness:
    """Of one process; `recording` takes everything down instead of comparing."""

    def __init__(self, records: Records, recording: bool = False) -> None:
        self.records = records
        self.recording = recording
        self.differing: list[str] = []
        self.changed: list[tuple[str, str, str, Result]] = []
        self._of_file: dict[str, dict[str, Any]] = {}
        self._file = ""
        self._tries: dict[tuple[str, str], int] = {}
        self._busy = False

    def begins(self, file: str) -> bool:
        """From here on calls belong to a test file; whether there is anything to see."""
        self._file = file
        if self.recording:
            self.records.setdefault(file, {})
        self._of_file = self.records.get(file, {})
        return self.recording or bool(self._of_file)

    def call(self, name: str, function: Callable[..., Any], args: Any, kwargs: Any) -> Any:
        """Call a function, and take what it returns, or what it did to its arguments."""
        if self._busy or not (self.recording or name in self._of_file):
            return function(*args, **kwargs)
        records, key = self._of_file, self._key(name, args, kwargs)
        result = function(*args, **kwargs)
        if key is not None:
            self._busy = True
            try:
                told = (args, kwargs) if result is None else result
                self._take(records, name, key, _flat(of_result(told)))
            finally:
                self._busy = False
        return result

    def _key(self, name: str, args: Any, kwargs: Any) -> str | None:
        tries = self._tries[self._file, name] = self._tries.get((self._file, name), 0) + 1
        if tries > MOST_TRIES:
            if not self.recording:
                del self._of_file[name]
            return None
        self._busy = True
        try:
            key = of_arguments(args, kwargs)
        except (Opaque, AttributeError, TypeError, ValueError):
            return None
        finally:
            self._busy = False
        if self.recording:
            return key
        return next((one for one in (key, key + ROUGH) if one in self._of_file[name]), None)

    def _take(self, records: dict[str, dict[str, Any]], name: str, key: str, found: Result) -> None:
        if self.recording:
            records.setdefault(name, {}).setdefault(key, []).append(found)
            return
        kept = records.get(name, {})
        if key not in kept:
            return
        record = kept.pop(key)
        if not kept:
            del records[name]
        if not same(record, found, ROUGH_SHARE if key.endswith(ROUGH) else SHARE):
            self.differing.append(f"{name}: {record} on record, {found} now")
            self.changed.append((self._file, name, key, found))

    def complain(self) -> None:
        """Raise if functions returned something else since the last call."""
        found, self.differing = self.differing, []
        if found:
            listed = "\n".join(found[:5])
            raise AssertionError(
                "for the arguments that are on record (tests/references/results), these return something "
                f"else. If that was meant: python -m tests.support.recorded_results {self._file}\n{listed}"
            )


def _flat(result: tuple[int, list[tuple[int, float, float]]]) -> Result:
    checksum, sums = result
    return [checksum, *(number for one in sums for number in one)]


def same(record: Result, found: Result, share: float) -> bool:
    """Whether two results agree."""
    if record[0] != found[0] or record[1::3] != found[1::3]:
        return False
    sums = zip(record[2::3], record[3::3], found[2::3], found[3::3], strict=True)
    return all(max(abs(a - c), abs(b - d)) <= share * max(a, c) + LEAST for a, b, c, d in sums)


def read() -> Records:
    """The record, which its files hold function by function."""
    found: Records = {}
    for file in sorted(FOLDER.glob("*.json")):
        for name, files in json.loads(file.read_text(encoding="utf-8")).items():
            for test_file, kept in files.items():
                found.setdefault(test_file, {})[name] = kept
    return found
