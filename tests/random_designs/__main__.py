"""Command that draws, builds and judges random specifications: one line of JSON for each.

`python -m tests.random_designs --first 0 --count 100 --table outcomes.jsonl`: seeds that the file
holds are not judged again, so that a study goes on where it stopped. `--seconds` ends it in time.
Without `--count` it only sums up what the file holds. `--generator edits` draws with other habits
(`draw_edits`), `--generator new` asks `instobj new` and `check --fabrication` (`new_requests`); a file
holds the seeds of one generator.
"""

from __future__ import annotations

import argparse
import json
import signal
import tempfile
import time
from pathlib import Path
from typing import Any

from instobj.search.apart import WorkerProcess, WorkerTimeout
from tests.random_designs.draw import kind_of
from tests.random_designs.judge import GENERATORS, judged, work_of
from tests.random_designs.new_requests import asked
from tests.random_designs.summary import summary, summary_of_requests

_REQUESTS = "new"
_PATIENCE_S = 6 * 3600.0
"""On a busy machine: how long a seed may take is judged by its processor time."""
_GIVEN_UP = f"exit code {-signal.SIGXCPU}"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--generator", choices=[*GENERATORS, _REQUESTS], default="placed")
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--count", type=int, default=0)
    parser.add_argument("--seconds", type=float, default=float("inf"))
    parser.add_argument("--table", type=Path, required=True)
    given = parser.parse_args()
    rows = read_rows(given.table)
    others = {_generator_of(row) for row in rows.values()} - {given.generator}
    if others:
        parser.error(
            f"{given.table} holds seeds of the generator {', '.join(others)}. Name another"
        )
    left = [s for s in range(given.first, given.first + given.count) if s not in rows]
    of_requests = given.generator == _REQUESTS
    apart, started = WorkerProcess(work_of, asked if of_requests else judged), time.monotonic()
    with given.table.open("a") as file, tempfile.TemporaryDirectory() as folder:
        for number, seed in enumerate(left, start=1):
            if time.monotonic() - started > given.seconds:
                break
            row = rows[seed] = _row(apart, given.generator, seed, folder)
            file.write(json.dumps(row) + "\n")
            file.flush()
            took = time.monotonic() - started
            print(
                f"{number}/{len(left)} seed {seed} {row['kind']}: {row['outcome']}, "
                f"{row['seconds']} s; {took / number * (len(left) - number) / 60:.0f} min left",
                flush=True,
            )
    apart.close()
    print((summary_of_requests if of_requests else summary)(list(rows.values())))


def _row(apart: WorkerProcess, generator: str, seed: int, folder: str) -> dict[str, Any]:
    question = {"generator": generator, "seed": seed, "folder": folder}
    try:
        return apart.ask(question, _PATIENCE_S)
    except WorkerTimeout as error:
        outcome = "slow" if _GIVEN_UP in str(error) else "crash"
        row = {"generator": generator, "seed": seed, "kind": kind_of(seed), "outcome": outcome}
        return row | {"seconds": None, "why": str(error)}


def _generator_of(row: dict[str, Any]) -> str:
    """Older rows do not name it: there was one."""
    return row.get("generator", "placed")


def read_rows(table: Path) -> dict[int, dict[str, Any]]:
    """Rows of a file by their seeds; the last one where a seed was judged again."""
    if not table.is_file():
        return {}
    rows = map(json.loads, table.read_text().splitlines())
    return {row["seed"]: row for row in rows}


if __name__ == "__main__":
    main()
