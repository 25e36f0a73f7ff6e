"""Common parts of all benchmarks: options, the machine's description, timing, files."""

from __future__ import annotations

import argparse
import json
import os
import platform
import re
import sys
import time
from collections.abc import Callable, Sequence
from datetime import UTC, datetime
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

from design.files import atomic_path

Result = dict[str, Any]
# `studies` is not installed: it lies beside this folder.
sys.path.append(str(Path(__file__).parents[1]))


def best_seconds(call: Callable[[], Any], repeats: int) -> float:
    """Least processor time of `repeats` calls after one to warm up."""
    call()
    times = []
    for _ in range(repeats):
        start = time.process_time()
        call()
        times.append(time.process_time() - start)
    return min(times)


def option_parser(title: str) -> argparse.ArgumentParser:
    """Options of every benchmark."""
    parser = argparse.ArgumentParser(description=title)
    parser.add_argument("--quick", action="store_true", help="a small form of the same")
    parser.add_argument("--out", type=Path, help="default: results/<processor> beside this file")
    return parser


def run(
    measure: Callable[..., Result],
    report: Callable[[Result], str],
    **extra: tuple[Callable[[str], Any], Any, str],
) -> None:
    """Command line of a script whose `measure` takes the quick form and the values of extra options.

    `extra` holds the type, the default and the help of each option by its name.
    """
    script = sys.modules["__main__"]
    parser = option_parser(script.__doc__ or "")
    for name, (kind, default, text) in extra.items():
        parser.add_argument(f"--{name}", type=kind, default=default, help=text)
    options = parser.parse_args()
    result = measure(options.quick, *(getattr(options, name) for name in extra))
    conclude(Path(script.__file__ or "").stem, options, result, report)


def machine(threads: int, packages: Sequence[str]) -> Result:
    """Return what the figures were measured on; None for a package that is not installed."""
    return {
        "processor": _processor(),
        "system": platform.system(),
        "python": platform.python_version(),
        "threads": threads,
        "load_average_at_start": os.getloadavg()[0] if hasattr(os, "getloadavg") else None,
        **{name: _version(name) for name in packages},
    }


def conclude(
    name: str,
    options: argparse.Namespace,
    result: Result,
    report: Callable[[Result], str],
) -> None:
    """Write `name`.json; print the report."""
    out = results_folder(options, result)
    title = (sys.modules["__main__"].__doc__ or name).splitlines()[0].rstrip(".")
    command = f"python benchmarks/{name}.py{' --quick' * options.quick}"
    record = described(title, command) | {"report": report(result).splitlines()} | result
    with atomic_path(out / f"{name}.json") as temporary:
        temporary.write_text(json.dumps(record, indent=2) + "\n", encoding="utf-8")
    print(report(result))


def described(title: str, command: str) -> Result:
    """Return what every results file says of itself; docs/measured.py makes pages of them."""
    today = datetime.now(UTC).date().isoformat()
    return {"title": title, "command": command, "version": version("instobj"), "date": today}


def results_folder(options: argparse.Namespace, result: Result) -> Path:
    """Return where a benchmark writes: `--out`, or one folder a processor."""
    slug = re.sub(r"[^a-z0-9]+", "-", result["machine"]["processor"].lower()).strip("-")
    return options.out or Path(__file__).parent / "results" / (slug or "unknown")


def parts_folder(name: str, form: str, options: argparse.Namespace, result: Result) -> Path:
    """Return where finished parts of one form of a benchmark stand until all are."""
    return results_folder(options, result) / f"{name}_parts_{form}"


def kept(parts: Path, name: str, measure: Callable[[], Any]) -> Any:
    """A part of the run, measured or read from where an interrupted run left it."""
    path = parts / f"{name}.json"
    if not path.is_file():
        with atomic_path(path) as temporary:
            temporary.write_text(json.dumps(measure()), encoding="utf-8")
    return json.loads(path.read_text(encoding="utf-8"))


def peak_memory_gb() -> float:
    """Largest resident memory of this process so far.

    Linux's own figure: what `getrusage` gives there also counts the process that started this one.
    """
    status = Path("/proc/self/status")
    if status.is_file():
        found = re.search(r"VmHWM:\s+(\d+) kB", status.read_text(encoding="utf-8"))
        if found:
            return int(found[1]) / 1024**2
    import resource

    unit = 1024**3 if platform.system() == "Darwin" else 1024**2
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / unit


def _processor() -> str:
    info = Path("/proc/cpuinfo")
    lines = info.read_text(encoding="utf-8").splitlines() if info.is_file() else []
    names = [line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")]
    return names[0] if names else platform.processor()


def _version(package: str) -> str | None:
    try:
        return version(package)
    except PackageNotFoundError:
        return None
