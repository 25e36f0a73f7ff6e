"""Plant random faults, one at a time, and see which the usual tests notice.

    python -m tests.planted_faults --folder planted [--faults 200] [--seed 1] [--packages fem …]
        [--copies 2] [--seconds 150] [--minutes M] [--list]

Lines that no usual test reaches get no faults. Each fault is planted in a copy of the checkout, and
the tests that reach its line run there, nearest first, until one fails, at most 150 s of them.
Faults that no test notices are listed at the end.

The folder keeps, each made if it is missing: `reach.json` (tests of each line, by a run of all usual
tests), `faults.jsonl` (what is planted; `--list` ends there) and `outcomes.jsonl`. A second call goes
on where the first stopped, also on another machine with the same code. Needs `pip install -e
'.[faults]'`, no network and no git; 200 faults take hours of two cores.
"""

from __future__ import annotations

import argparse
import json
import queue
import random
import sys
import threading
import time
from dataclasses import asdict
from pathlib import Path
from typing import Any

from scipy.stats import binomtest

from tests.planted_faults.copies import NOTICED, Clock, Copy, OutOfTime
from tests.planted_faults.reach import Reach, reach
from tests.planted_faults.sites import Fault, faults_in, packages_files

ROOT = Path(__file__).parents[2]
PACKAGES = ("design", "fem", "estimator")


def drawn(found: Reach, packages: tuple[str, ...], count: int, seed: int) -> list[Fault]:
    """Random faults on lines that tests reach, each once."""
    every = [
        fault
        for path in packages_files(ROOT, packages)
        for fault in faults_in(ROOT, path)
        if fault.line in found.lines.get(path, {})
    ]
    print(f"{len(every)} faults could be planted on lines that tests reach", flush=True)
    return random.Random(seed).sample(every, min(count, len(every)))


def kept(faults_file: Path) -> list[Fault]:
    """Faults of an earlier call; the code must be as it was then."""
    faults = [Fault(**one) for one in _lines(faults_file)]
    possible = {path: set(faults_in(ROOT, path)) for path in {fault.path for fault in faults}}
    moved = [fault for fault in faults if fault not in possible[fault.path]]
    if moved:
        sys.exit(
            f"error: {moved[0].path} has changed since {faults_file} was written ({len(moved)} of "
            f"{len(faults)} faults). Use another folder, or remove that file and outcomes.jsonl"
        )
    return faults


def plant(
    faults: list[Fault], found: Reach, folder: Path, copies: int, clock: Clock
) -> list[dict[str, Any]]:
    """Outcomes of the faults judged so far, kept in `outcomes.jsonl` as they come."""
    file = folder / "outcomes.jsonl"
    done = {_identity(one): one for one in _lines(file)}
    waiting: queue.Queue[Fault] = queue.Queue()
    for fault in faults:
        if _identity(asdict(fault)) not in done:
            waiting.put(fault)
    lock = threading.Lock()

    def work(number: int) -> None:
        copy = Copy.made(ROOT, folder / f"copy_{number}", clock)
        while time.monotonic() < clock.end:
            try:
                fault = waiting.get_nowait()
                tests = found.tests_of(fault.path, fault.line)
                outcome = asdict(fault) | copy.judged(fault, tests, found.seconds)
            except (queue.Empty, OutOfTime):
                return
            with lock, file.open("a", encoding="utf-8") as stream:
                stream.write(json.dumps(outcome) + "\n")
                done[_identity(outcome)] = outcome
                print(f"{len(done)} of {len(faults)}: {_said(outcome)}", flush=True)

    workers = [threading.Thread(target=work, args=(number,)) for number in range(copies)]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    known = [done.get(_identity(asdict(fault))) for fault in faults]
    return [outcome for outcome in known if outcome is not None]


def _lines(file: Path) -> list[dict[str, Any]]:
    """Records of a file of one JSON a line; one that was cut as it was written is left out."""
    text = file.read_text(encoding="utf-8") if file.exists() else ""
    return [json.loads(line) for line in text.splitlines() if line.endswith("}")]


def _identity(fault: dict[str, Any]) -> tuple[Any, ...]:
    return tuple(fault[name] for name in ("path", "begin", "end", "text"))


def _planted_line(fault: dict[str, Any]) -> str:
    source = (ROOT / fault["path"]).read_text(encoding="utf-8")
    begin, end = fault["begin"], fault["end"]
    start = source.rfind("\n", 0, begin) + 1
    stop = source.find("\n", end)
    line = f"{source[start:begin]}⟦{source[begin:end]} → {fault['text']}⟧{source[end:stop]}"
    return f"{fault['path']}:{fault['line']} {line.strip()}"


def _said(outcome: dict[str, Any]) -> str:
    by = f" by {outcome['by']}" if outcome["by"] else f" by {outcome['of']} tests"
    return f"{outcome['outcome']}{by} ({outcome['seconds']:.0f} s): {_planted_line(outcome)}"


def summary(outcomes: list[dict[str, Any]]) -> str:
    """Shares that were noticed, with 95 % Wilson intervals, and what was not."""
    lines = ["package    planted  noticed  share (95 %)"]
    packages = sorted({one["path"].split("/")[0] for one in outcomes})
    for package in [*packages, ""]:
        mine = [one for one in outcomes if one["path"].startswith(package)]
        noticed = sum(one["outcome"] in NOTICED for one in mine)
        low, high = binomtest(noticed, len(mine)).proportion_ci(method="wilson")
        share = f"{100 * noticed / len(mine):.1f} % ({100 * low:.1f} to {100 * high:.1f})"
        lines.append(f"{package or 'all':10} {len(mine):7} {noticed:8}  {share}")
    missed = [_said(one) for one in outcomes if one["outcome"] not in NOTICED]
    return "\n".join([*lines, "", *missed])


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    parser.add_argument("--folder", type=Path, required=True, help="for copies and results")
    parser.add_argument("--faults", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    everything = (*PACKAGES, "instobj")
    parser.add_argument("--packages", nargs="+", default=list(PACKAGES), choices=everything)
    parser.add_argument("--copies", type=int, default=2, help="faults in work at a time")
    parser.add_argument("--seconds", type=float, default=150.0, help="of tests for a fault")
    parser.add_argument("--minutes", type=float, help="end then; the next call goes on")
    parser.add_argument("--list", action="store_true", help="draw the faults and plant none")
    options = parser.parse_args()
    for name in ("faults", "copies", "seconds"):
        if getattr(options, name) <= 0:
            parser.error(f"--{name} must be more than 0; got {getattr(options, name)}")
    return options


def main() -> None:
    began, options = time.monotonic(), _options()
    folder = options.folder.absolute()
    folder.mkdir(parents=True, exist_ok=True)
    found = reach(ROOT, folder, options.copies)
    file = folder / "faults.jsonl"
    if not file.exists():
        drawing = drawn(found, tuple(options.packages), options.faults, options.seed)
        file.write_text("".join(f"{json.dumps(asdict(fault))}\n" for fault in drawing), "utf-8")
    faults = kept(file)
    if options.list:
        print("\n".join(_planted_line(asdict(fault)) for fault in faults))
        return
    end = began + 60 * options.minutes if options.minutes else float("inf")
    outcomes = plant(faults, found, folder, options.copies, Clock(options.seconds, end))
    print(summary(outcomes) if outcomes else "no fault was judged in time")
    if len(outcomes) < len(faults):
        sys.exit(f"{len(faults) - len(outcomes)} faults are left: call again")


if __name__ == "__main__":
    main()
