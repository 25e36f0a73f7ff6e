"""Plant random faults, one at a time, and see which the usual tests notice.

    python -m tests.planted_faults --folder planted [--faults 200] [--seed 1] [--packages fem …]

Lines that no usual test reaches get no faults. Each fault is planted in a copy of the checkout, and
the test files that reach its line run there, nearest first, until one fails, at most 150 s of them.
Two copies work at a time. Faults that no test notices are listed at the end. A second call goes on
where the first stopped. Needs `pip install -e '.[faults]'`; 200 faults take hours.
"""

from __future__ import annotations

import argparse
import json
import os
import queue
import random
import re
import shutil
import subprocess
import sys
import threading
import time
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from scipy.stats import binomtest

from tests.planted_faults.reach import Reach, reach
from tests.planted_faults.sites import Fault, faults_in, packages_files

ROOT = Path(__file__).parents[2]
PACKAGES = ("design", "fem", "estimator")
COPIES = 2
MOST_S = 150.0
"""Of tests a fault, timed without it; what they do not notice counts as not noticed."""
SLOWER = 4.0
LEAST_S = 120.0
"""A test file that takes so many times as long as without the fault hangs: that is noticed too."""
NOTICED = ("noticed", "hangs")


@dataclass(frozen=True)
class Copy:
    """A checkout of its own, in which faults are planted."""

    root: Path

    @classmethod
    def made(cls, root: Path) -> Copy:
        shutil.rmtree(root, ignore_errors=True)
        listed = subprocess.run(
            ["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, text=True, check=True
        )
        for name in filter(None, listed.stdout.split("\0")):
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ROOT / name, root / name)
        return cls(root)

    def judged(self, fault: Fault, tests: list[str], seconds: dict[str, float]) -> dict[str, Any]:
        """The outcome: noticed, hangs, or not noticed, and by which test file."""
        began = time.monotonic()
        target = self.root / fault.path
        source = target.read_text(encoding="utf-8")
        target.write_text(fault.planted_in(source), encoding="utf-8")
        try:
            outcome, by = "not noticed", ""
            for batch in batches(tests, seconds):
                limit_s = LEAST_S + SLOWER * sum(seconds.get(test, 0.0) for test in batch)
                outcome, by = self._run(batch, limit_s)
                if outcome in NOTICED:
                    break
        finally:
            target.write_text(source, encoding="utf-8")
        took_s = round(time.monotonic() - began, 1)
        return {"outcome": outcome, "by": by, "of": len(tests), "seconds": took_s}

    def _run(self, tests: list[str], limit_s: float) -> tuple[str, str]:
        command = [sys.executable, "-m", "pytest", "-x", "-q", "-p", "no:cacheprovider", *tests]
        threads = {"OMP_NUM_THREADS": "1", "MKL_NUM_THREADS": "1"}
        alone = {"PYTHONDONTWRITEBYTECODE": "1", "PYTHONPATH": str(self.root)}
        try:
            done = subprocess.run(
                command,
                cwd=self.root,
                env=os.environ | threads | alone,
                capture_output=True,
                text=True,
                timeout=limit_s,
                check=False,
            )
        except subprocess.TimeoutExpired:
            return "hangs", tests[0]
        if done.returncode in (0, 5):
            return "not noticed", ""
        failed = re.search(r"^(?:FAILED|ERROR) (\S+)", done.stdout, re.MULTILINE)
        return "noticed", failed[1] if failed else tests[0]


def batches(tests: list[str], seconds: dict[str, float]) -> list[list[str]]:
    """The likeliest file alone, then more and more at a time, up to `MOST_S` of tests in all."""
    found: list[list[str]] = []
    left, spent, size = list(tests), 0.0, 1
    while left:
        batch = []
        while left and len(batch) < size:
            if spent and spent + seconds.get(left[0], 0.0) > MOST_S:
                left = []
                break
            spent += seconds.get(left[0], 0.0)
            batch.append(left.pop(0))
        if batch:
            found.append(batch)
        size *= 4
    return found


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


def plant(faults: list[Fault], found: Reach, folder: Path) -> list[dict[str, Any]]:
    """Outcomes of all faults, kept in `outcomes.jsonl` as they come."""
    file = folder / "outcomes.jsonl"
    known = [json.loads(line) for line in file.read_text().splitlines()] if file.exists() else []
    done = {_identity(one): one for one in known}
    waiting: queue.Queue[Fault] = queue.Queue()
    for fault in faults:
        if _identity(asdict(fault)) not in done:
            waiting.put(fault)
    lock = threading.Lock()

    def work(number: int) -> None:
        copy = Copy.made(folder / f"copy_{number}")
        while True:
            try:
                fault = waiting.get_nowait()
            except queue.Empty:
                return
            tests = found.tests_of(fault.path, fault.line)
            outcome = asdict(fault) | copy.judged(fault, tests, found.seconds)
            with lock, file.open("a", encoding="utf-8") as stream:
                stream.write(json.dumps(outcome) + "\n")
                done[_identity(outcome)] = outcome
                print(f"{len(done)} of {len(faults)}: {_said(outcome)}", flush=True)

    workers = [threading.Thread(target=work, args=(number,)) for number in range(COPIES)]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    return [done[_identity(asdict(fault))] for fault in faults]


def _identity(fault: dict[str, Any]) -> tuple[Any, ...]:
    return tuple(fault[name] for name in ("path", "begin", "end", "text"))


def _said(outcome: dict[str, Any]) -> str:
    source = (ROOT / outcome["path"]).read_text(encoding="utf-8")
    begin, end = outcome["begin"], outcome["end"]
    start = source.rfind("\n", 0, begin) + 1
    stop = source.find("\n", end)
    line = (
        f"{source[start:begin]}⟦{source[begin:end]} → {outcome['text']}⟧{source[end:stop]}".strip()
    )
    by = f" by {outcome['by']}" if outcome["by"] else f" by {outcome['of']} files"
    took = f"{outcome['seconds']:.0f} s"
    return f"{outcome['outcome']}{by} ({took}): {outcome['path']}:{outcome['line']} {line}"


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


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    parser.add_argument("--folder", type=Path, required=True, help="for copies and results")
    parser.add_argument("--faults", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    everything = (*PACKAGES, "instobj")
    parser.add_argument("--packages", nargs="+", default=list(PACKAGES), choices=everything)
    options = parser.parse_args()
    if options.faults < 1:
        parser.error(f"--faults must be 1 or more; got {options.faults}")
    folder = options.folder.absolute()
    folder.mkdir(parents=True, exist_ok=True)
    found = reach(ROOT, folder)
    faults = drawn(found, tuple(options.packages), options.faults, options.seed)
    print(summary(plant(faults, found, folder)))


if __name__ == "__main__":
    main()
