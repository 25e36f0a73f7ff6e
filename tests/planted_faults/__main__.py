"""Plant random faults, one at a time, and see which the usual tests notice.

    python -m tests.planted_faults --folder planted [--faults 240] [--seed 1] [--packages fem …]
        [--copies 1] [--seconds 150] [--minutes M] [--list]

Each fault is planted in a copy of the checkout, and the usual tests that import its file run there,
those of its room that call its function first, until one fails, at most 150 s of processor time.
Faults that no test notices are listed at the end; those in statements that no test ran are told apart
and count neither way.

The folder keeps `faults.jsonl` (what is planted; `--list` ends there), `learnt.jsonl` (what tests call)
and `outcomes.jsonl`. A second call goes on where the first stopped, also on another machine with the
same code. Needs no network and no git; most faults take a second or two, the start some minutes.
"""

from __future__ import annotations

import argparse
import json
import random
import subprocess
import sys
from dataclasses import asdict
from pathlib import Path
from typing import Any

from tests.planted_faults.copies import copied, environment
from tests.planted_faults.sites import Fault, faults_in, packages_files

ROOT = Path(__file__).parents[2]
PACKAGES = ("design", "fem", "estimator")
NOTICED = ("noticed", "hangs")


def drawn(packages: tuple[str, ...], count: int, seed: int) -> list[Fault]:
    """Random faults, each once; of a longer draw the first are the same."""
    paths = packages_files(ROOT, packages)
    every = [fault for path in paths for fault in faults_in(ROOT, path)]
    print(f"{len(every)} faults could be planted", flush=True)
    return random.Random(seed).sample(every, len(every))[:count]


def kept(faults_file: Path) -> list[Fault]:
    """Faults of an earlier call; the code must be as it was then."""
    faults = [Fault(**one) for one in lines(faults_file)]
    possible = {path: set(faults_in(ROOT, path)) for path in {fault.path for fault in faults}}
    moved = [fault for fault in faults if fault not in possible[fault.path]]
    if moved:
        sys.exit(
            f"error: {moved[0].path} has changed since {faults_file} was written ({len(moved)} of "
            f"{len(faults)} faults). Use another folder, or remove that file and outcomes.jsonl"
        )
    return faults


def plant(folder: Path, options: argparse.Namespace) -> None:
    """Judge what is left of the draw, by one process for each copy of the checkout."""
    servers = []
    for number in range(options.copies):
        root = copied(ROOT, folder / f"copy_{number}")
        part = [str(folder), str(number), str(options.copies), str(options.seconds)]
        minutes = [] if options.minutes is None else [str(options.minutes)]
        command = [sys.executable, "-m", "tests.planted_faults.server", *part, *minutes]
        servers.append(subprocess.Popen(command, cwd=root, env=environment(root)))
    for server in servers:
        server.wait()


def lines(file: Path) -> list[dict[str, Any]]:
    """Records of a file of one JSON per line; one that was cut as it was written is left out."""
    text = file.read_text(encoding="utf-8") if file.exists() else ""
    return [json.loads(line) for line in text.splitlines() if line.endswith("}")]


def identity(fault: dict[str, Any]) -> tuple[Any, ...]:
    return tuple(fault[name] for name in ("path", "begin", "end", "text"))


def _planted_line(root: Path, fault: dict[str, Any]) -> str:
    source = (root / fault["path"]).read_text(encoding="utf-8")
    begin, end = fault["begin"], fault["end"]
    start = source.rfind("\n", 0, begin) + 1
    stop = source.find("\n", end)
    line = f"{source[start:begin]}⟦{source[begin:end]} → {fault['text']}⟧{source[end:stop]}"
    return f"{fault['path']}:{fault['line']} {line.strip()}"


def said(root: Path, outcome: dict[str, Any]) -> str:
    by = f" by {outcome['by']}" if outcome["by"] else f" by {outcome['of']} tests"
    return f"{outcome['outcome']}{by} ({outcome['seconds']:.0f} s): {_planted_line(root, outcome)}"


def summary(outcomes: list[dict[str, Any]]) -> str:
    """Shares of what tests reach that were noticed, with 95 % Wilson intervals, and what was not."""
    from scipy.stats import binomtest

    reached = [one for one in outcomes if one["outcome"] != "not reached"]
    told = ["package    planted  noticed  share (95 %)"]
    for package in [*sorted({one["path"].split("/")[0] for one in reached}), ""]:
        mine = [one for one in reached if one["path"].startswith(package)]
        if not mine:
            continue
        noticed = sum(one["outcome"] in NOTICED for one in mine)
        low, high = binomtest(noticed, len(mine)).proportion_ci(method="wilson")
        share = f"{100 * noticed / len(mine):.1f} % ({100 * low:.1f} to {100 * high:.1f})"
        told.append(f"{package or 'all':10} {len(mine):7} {noticed:8}  {share}")
    missed = [said(ROOT, one) for one in outcomes if one["outcome"] not in NOTICED]
    return "\n".join([*told, "", *sorted(missed)])


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    parser.add_argument("--folder", type=Path, required=True, help="for copies and results")
    parser.add_argument("--faults", type=int, default=240)
    parser.add_argument("--seed", type=int, default=1)
    everything = (*PACKAGES, "instobj")
    parser.add_argument("--packages", nargs="+", default=list(PACKAGES), choices=everything)
    parser.add_argument("--copies", type=int, default=1, help="faults in work at a time")
    parser.add_argument("--seconds", type=float, default=150.0, help="of tests for a fault")
    parser.add_argument("--minutes", type=float, help="end then; the next call goes on")
    parser.add_argument("--list", action="store_true", help="draw the faults and plant none")
    options = parser.parse_args()
    for name in ("faults", "copies", "seconds"):
        if getattr(options, name) <= 0:
            parser.error(f"--{name} must be more than 0; got {getattr(options, name)}")
    return options


def main() -> None:
    options = _options()
    folder = options.folder.absolute()
    folder.mkdir(parents=True, exist_ok=True)
    file = folder / "faults.jsonl"
    if not file.exists():
        drawing = drawn(tuple(options.packages), options.faults, options.seed)
        file.write_text("".join(f"{json.dumps(asdict(fault))}\n" for fault in drawing), "utf-8")
    faults = kept(file)
    if options.list:
        print("\n".join(_planted_line(ROOT, asdict(fault)) for fault in faults))
        return
    plant(folder, options)
    done = {identity(one): one for one in lines(folder / "outcomes.jsonl")}
    known = [done.get(identity(asdict(fault))) for fault in faults]
    outcomes = [outcome for outcome in known if outcome is not None]
    print(summary(outcomes) if outcomes else "no fault was judged in time")
    if len(outcomes) < len(faults):
        sys.exit(f"{len(faults) - len(outcomes)} faults are left: call again")


if __name__ == "__main__":
    main()
