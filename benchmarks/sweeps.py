"""Time of a sweep over specifications that share nothing, by one and by two processes.

    python benchmarks/sweeps.py [--quick] [--out FOLDER]

Cubes of several shell thicknesses are taken to their scores with an empty store, by one process and by
two, by turns. One thread for each process; time on the clock, start of processes included. The mesher
gives another mesh each time. Writes `sweeps.json`.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from harness import Result, machine, run

ROOT = Path(__file__).parents[1]
QUICK = ("examples/gallery/small_cube.toml", (8.0, 8.5), 1)
WHOLE = ("examples/paper_cube.toml", tuple(7.5 + 0.25 * n for n in range(8)), 2)
"""Specification, thicknesses of the shell (mm), turns."""
STUDY = """name = "thickness"
specification = "{}"
[grid]
"shell.thickness_mm" = {}
"""


def measure(quick: bool) -> Result:
    """Seconds of every turn by number of processes."""
    example, thicknesses_mm, turns = QUICK if quick else WHOLE
    seconds: dict[str, list[float]] = {"1": [], "2": []}
    for _ in range(turns):
        for workers, found in seconds.items():
            found.append(_seconds(STUDY.format(ROOT / example, list(thicknesses_mm)), workers))
    return {
        "machine": machine(1, ["numpy", "scipy", "pypardiso", "dask"]),
        "cores": os.cpu_count(),
        "quick": quick,
        "specifications": len(thicknesses_mm),
        "seconds": seconds,
        "ratios": [
            round(one / two, 3) for one, two in zip(seconds["1"], seconds["2"], strict=True)
        ],
    }


def _seconds(study: str, workers: str) -> float:
    one_thread = {"OMP_NUM_THREADS": "1", "MKL_NUM_THREADS": "1", "PYTHONPATH": str(ROOT)}
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "study.toml").write_text(study, encoding="utf-8")
        command = [sys.executable, "-m", "instobj", "sweep", "study.toml", "--workers", workers]
        began = time.perf_counter()
        subprocess.run(
            command,
            cwd=folder,
            env=os.environ | one_thread | {"INSTOBJ_STORE": f"{folder}/store"},
            check=True,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        return round(time.perf_counter() - began, 2)


def report(result: Result) -> str:
    """Turn by turn."""
    rows = [f"{result['specifications']} specifications, {result['cores']} cores"]
    for one, two, ratio in zip(*result["seconds"].values(), result["ratios"], strict=True):
        rows.append(f"one process {one:7.1f} s, two {two:7.1f} s: {ratio:.2f} times")
    return "\n".join(rows)


if __name__ == "__main__":
    run(measure, report)
