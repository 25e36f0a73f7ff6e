"""Tests of the rooms where the last bits decide, under the ways in which processors round: a table.

Walks, CMA-ES, training and large solves end elsewhere where sums are taken in another order. What they
promise must hold all the same: `make test-rounding`, once per release. MKL and torch are told to compute as
on older processors; two threads split sums; inputs are disturbed by a millionth.
"""

import argparse
import json
import os
import platform
import re
import subprocess
import sys
import time
from importlib.metadata import version
from pathlib import Path

from benchmarks.harness import Result, described
from design.processes import ONE_THREAD
from tests.support.disturbed_inputs import SWITCH

ROOT = Path(__file__).parents[1]
RESULTS = ROOT / "benchmarks" / "results" / "rounding.json"
WHAT = (
    "The rooms where the last bit decides, with MKL and torch as on older processors, on two threads, "
    "and with inputs disturbed by 1e-6. The last run of a part; — was not run."
)
_LAYOUTS, _SEARCH = "tests/estimator/layouts", "tests/instobj/search"
ROOMS = {
    "walks": (
        *(f"{_LAYOUTS}/test_{name}.py" for name in ("walk", "bounds", "scoring")),
        *(f"{_SEARCH}/test_{name}.py" for name in ("lowest_fidelity", "corrected")),
    ),
    "layouts": (_LAYOUTS,),
    "search": (_SEARCH,),
    "networks": ("tests/estimator/networks",),
    "inversion": ("tests/estimator/inversion",),
    "mechanics": ("tests/fem/linear", "tests/fem/contact"),
}
"""Where sums in another order change more than the last digits; "walks" are quick ones of the next two."""
SETTINGS = {
    "as it is": {},
    **{f"MKL {one}": {"MKL_CBWR": one} for one in ("COMPATIBLE", "SSE4_2", "AVX2", "AVX512")},
    **{f"torch {one}": {"ATEN_CPU_CAPABILITY": one} for one in ("default", "avx2", "avx512")},
    "two threads": dict.fromkeys(ONE_THREAD, "2"),
    "inputs × (1 ± 1e-6)": {SWITCH: "1e-6"},
}


def outcome(room: str, setting: str, seconds: float) -> str:
    """Run a room's usual tests; failed and passed ones and the time, or why there are none."""
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "-rfE", *ROOMS[room]]
    began = time.monotonic()
    try:
        done = subprocess.run(
            command,
            cwd=ROOT,
            env=os.environ | ONE_THREAD | SETTINGS[setting],
            capture_output=True,
            text=True,
            timeout=seconds,
        )
    except subprocess.TimeoutExpired:
        return f"not ended in {seconds:.0f} s"
    took = time.monotonic() - began
    failed = re.findall(r"^(?:FAILED|ERROR) (\S+)", done.stdout, re.MULTILINE)
    print("\n".join(failed), file=sys.stderr)
    passed = re.search(r"(\d+) passed", done.stdout)
    if passed is None:
        return "no result"
    return f"{len(failed)} of {len(failed) + int(passed[1])} fail, {took:.0f} s"


def record(outcomes: dict[tuple[str, str], str]) -> Result:
    """Return the results file: rows are settings, columns rooms; "—" was not run."""
    rows = [[name, *(outcomes.get((room, name), "—") for room in ROOMS)] for name in SETTINGS]
    return described("Other processors", "make test-rounding") | {
        "what": WHAT,
        "machine": f"{os.cpu_count()} cores of {processor()}, torch {version('torch')}",
        "tables": [{"columns": ["setting", *ROOMS], "rows": rows}],
    }


def processor() -> str:
    """Its name, where the system tells it."""
    known = Path("/proc/cpuinfo")
    told = re.search(r"model name\s*: (.+)", known.read_text()) if known.is_file() else None
    return told[1] if told else platform.machine()


def written() -> dict[tuple[str, str], str]:
    """Return the outcomes in the results file: a part that is run again replaces its own alone."""
    (table,) = json.loads(RESULTS.read_text(encoding="utf-8"))["tables"]
    return {
        (room, setting): cell
        for setting, *cells in table["rows"]
        if setting in SETTINGS
        for room, cell in zip(ROOMS, cells, strict=True)
        if cell != "—"
    }


def write(outcomes: dict[tuple[str, str], str]) -> None:
    """Write the results file; `python docs/measured.py` makes the page of it."""
    text = json.dumps(record(outcomes), indent=1, ensure_ascii=False)
    RESULTS.write_text(text + "\n", encoding="utf-8")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--room", action="append", choices=ROOMS)
    parser.add_argument("--setting", action="append", choices=SETTINGS)
    parser.add_argument("--seconds", type=float, default=3600.0, help="for a room, at most")
    asked = parser.parse_args()
    outcomes = written()
    for room in asked.room or ROOMS:
        for setting in asked.setting or SETTINGS:
            outcomes[room, setting] = outcome(room, setting, asked.seconds)
            print(f"{room}, {setting}: {outcomes[room, setting]}", file=sys.stderr)
            write(outcomes)
    if any(not one.startswith("0 of ") for one in outcomes.values()):
        sys.exit(1)


if __name__ == "__main__":
    main()
