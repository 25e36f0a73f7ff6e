"""Write results on record anew, after a change that was meant to change them.

    python -m tests.support.recorded_results [tests/FOLDER or FILE …]

runs these test files (without any: all that are on record) and puts results that have changed in the
place of the old ones. Look at the difference, and say in the commit why it changed. With `--add`
everything that these files see is recorded: they run twice, the second time in the other order, on the
oldest instruction sets and with instobj's own solver, and what both agree on to 1e-8, or roughly to 1e-5,
goes on record.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from itertools import groupby
from pathlib import Path
from typing import Any

from design.files import atomic_path
from tests.support.recorded_results.sessions import CHANGED, RECORDING
from tests.support.recorded_results.witness import FOLDER, ROUGH, Records, Result, read, same

ROOT = Path(__file__).parents[3]
MOST_FILES = 3
MOST_ARGUMENTS = 3
"""Of each function: test files, and arguments in each."""
NOT_RECORDED = (
    "design.files", "design.netcdf", "design.processes", "estimator.boards.growing",
    "estimator.boards.link", "estimator.recordings.formats.netcdf",
)  # fmt: skip
"""Modules whose results hang on time, disk or the version of a library."""
AGREE, AGREE_ROUGHLY = 1e-8, 1e-5
OTHER = {
    "OPENBLAS_CORETYPE": "Nehalem",
    "MKL_ENABLE_INSTRUCTIONS": "SSE4_2",
    "ATEN_CPU_CAPABILITY": "default",
    "NPY_DISABLE_CPU_FEATURES": "AVX2 FMA3 AVX512F AVX512_SKX",
    "INSTOBJ_MKL": "0",
}
"""Another processor, as far as libraries let themselves be told."""


def seen(files: list[str], settings: dict[str, str], what: str = RECORDING) -> Any:
    """What a run of some test files tells: every result by file, function and key, or those changed."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "results.json"
        environment = os.environ | settings | {what: str(file), "OMP_NUM_THREADS": "1"}
        options = ["-q", "-p", "no:cacheprovider", "-p", "no:xdist"]
        command = [sys.executable, "-m", "pytest", *options, *files]
        subprocess.run(command, cwd=ROOT, env=environment)  # some of MKL fail without it
        return json.loads(file.read_text(encoding="utf-8"))


def agreed(one: Records, other: Records) -> Records:
    """Results that are the same wherever a function was given the same."""
    every: dict[tuple[str, str], list[Result]] = {}
    for name, key, _, results in [*_entries(one), *_entries(other)]:
        every.setdefault((name, key), []).extend(results)
    sound = {}
    for at, (first, *others) in every.items():
        for ending, share in (("", AGREE), (ROUGH, AGREE_ROUGHLY)):
            if others and all(same(first, result, share) for result in others):
                sound[at] = ending, first
                break
    found: Records = {}
    both = {(name, key, file) for name, key, file, _ in _entries(other)}
    for name, key, file, _ in _entries(one):
        if (name, key) in sound and (name, key, file) in both:
            ending, result = sound[name, key]
            found.setdefault(file, {}).setdefault(name, {})[key + ending] = result
    return found


def _entries(records: Records) -> Iterator[tuple[str, str, str, list[Result]]]:
    for file, functions in records.items():
        for name, kept in functions.items():
            for key, results in kept.items():
                yield name, key, file, results


def chosen(records: Records) -> Records:
    """Of every function the nearest test files, and of these the most varied results, each once."""
    found: Records = {}
    records = {
        file: {name: kept for name, kept in functions.items() if not name.startswith(NOT_RECORDED)}
        for file, functions in records.items()
    }
    for name, entries in groupby(
        sorted(_entries(records), key=lambda one: one[0]), lambda one: one[0]
    ):
        files: dict[str, dict[str, Result]] = {}
        for _, key, file, result in entries:
            files.setdefault(file, {})[key] = result
        taken: set[str] = set()
        for file in sorted(files, key=lambda file: _distance(name, file))[:MOST_FILES]:
            kept = _varied({key: one for key, one in files[file].items() if key not in taken})
            taken |= kept.keys()
            if kept:
                found.setdefault(file, {})[name] = kept
    return found


def _distance(name: str, file: str) -> tuple[bool, int, str]:
    """Of a test file from a function: same name, then how few folders they share."""
    module = name.split(".")
    folders = file.split("/")[1:-1]
    stem = file.split("/")[-1].removeprefix("test_").removesuffix(".py")
    shared = sum(a == b for a, b in zip(module, folders, strict=False))
    return stem not in module, -shared, file


def _varied(kept: dict[str, Result]) -> dict[str, Result]:
    """First one of each form."""
    forms: dict[str, int] = {}
    rank = {}
    for key, result in sorted(kept.items()):
        form = str([result[0], *result[1::3]])
        forms[form] = rank[key] = forms.get(form, -1) + 1
    first = sorted(kept, key=lambda key: (rank[key], key))[:MOST_ARGUMENTS]
    return {key: _rounded(kept[key]) for key in sorted(first)}


def _rounded(result: Result) -> Result:
    return [float(f"{one:.8e}") if isinstance(one, float) else one for one in result]


def write(records: Records) -> None:
    """A file for each package, a line for each function."""
    by_name: dict[str, dict[str, dict[str, Result]]] = {}
    for file, functions in sorted(records.items()):
        for name, kept in functions.items():
            by_name.setdefault(name, {})[file] = kept
    FOLDER.mkdir(exist_ok=True)
    for package in sorted({name.split(".")[0] for name in by_name}):
        lines = [
            f"{json.dumps(name)}: {json.dumps(kept, separators=(',', ':'))}"
            for name, kept in sorted(by_name.items())
            if name.startswith(f"{package}.")
        ]
        with atomic_path(FOLDER / f"{package}.json") as path:
            path.write_text("{\n" + ",\n".join(lines) + "\n}\n", encoding="utf-8")


def main() -> None:
    before = read()
    given = [path for name in sys.argv[1:] if name != "--add" for path in _test_files(name)]
    files = given or sorted(before)
    if "--add" in sys.argv:
        found = agreed(seen(files, {}), seen(files[::-1], OTHER))
        rest = {file: kept for file, kept in before.items() if file not in files}
        write(chosen(rest | found))
        return
    changed = seen(files, {}, CHANGED)
    updated(before, changed)
    write(before)
    print(
        f"changed: {len(changed)} results of {len({name for _, name, _, _ in changed})} functions"
    )


def updated(records: Records, changed: list[tuple[str, str, str, Result]]) -> None:
    """Put what functions return now in the place of what they returned."""
    for file, name, key, result in changed:
        records[file][name][key] = _rounded(result)


def _test_files(name: str) -> list[str]:
    path = ROOT / name
    paths = [path] if path.is_file() else sorted(path.rglob("test_*.py"))
    return [one.relative_to(ROOT).as_posix() for one in paths]


if __name__ == "__main__":
    main()
