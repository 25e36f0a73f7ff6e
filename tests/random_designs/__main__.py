"""Command that draws, builds and judges random specifications, and writes a table of outcomes.

`python -m tests.random_designs --first 0 --count 100 --table outcomes.csv`: seeds that the table
holds are not judged again, so that a study goes on where it stopped.
"""

from __future__ import annotations

import argparse
import csv
import signal
import tempfile
from collections import Counter
from pathlib import Path

from tests.random_designs.judge import judged
from tests.support.building_apart import Apart

COLUMNS = ("seed", "outcome", "seconds", "why")
_PATIENCE_S = 6 * 3600.0
"""On a busy machine: how long a seed may take is judged by its processor time."""
_GIVEN_UP = f"exit code {-signal.SIGXCPU}"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--table", type=Path, required=True)
    given = parser.parse_args()
    known = _known(given.table)
    apart = Apart(judged)
    with given.table.open("a", newline="") as file, tempfile.TemporaryDirectory() as folder:
        table = csv.DictWriter(file, COLUMNS)
        if not known:
            table.writeheader()
        for seed in range(given.first, given.first + given.count):
            if seed in known:
                continue
            row = _row(apart, seed, folder)
            known[seed] = row["outcome"]
            table.writerow(row)
            file.flush()
    apart.close()
    print(dict(Counter(known.values())))


def _row(apart: Apart, seed: int, folder: str) -> dict[str, object]:
    try:
        return apart.ask({"seed": seed, "folder": folder}, _PATIENCE_S)
    except AssertionError as error:
        outcome = "slow" if _GIVEN_UP in str(error) else "crash"
        return {"seed": seed, "outcome": outcome, "seconds": None, "why": str(error)}


def _known(table: Path) -> dict[int, str]:
    if not table.is_file():
        return {}
    with table.open(newline="") as file:
        return {int(row["seed"]): row["outcome"] for row in csv.DictReader(file)}


if __name__ == "__main__":
    main()
