"""Copies of the checkout in which faults are planted."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path


def copied(source: Path, root: Path) -> Path:
    """A fresh copy of a checkout."""
    shutil.rmtree(root, ignore_errors=True)
    for name in sources(source):
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(source / name, root / name)
    return root


def environment(root: Path) -> dict[str, str]:
    """For tests of a checkout: its code first, one thread each, compiled modules kept."""
    threads = dict.fromkeys(("OMP_NUM_THREADS", "MKL_NUM_THREADS", "OPENBLAS_NUM_THREADS"), "1")
    paths = [str(root), *filter(None, [os.environ.get("PYTHONPATH")])]
    kept = {"PYTHONPATH": os.pathsep.join(paths), "PYTHONDONTWRITEBYTECODE": ""}
    return os.environ | threads | kept


def sources(root: Path) -> list[str]:
    """Files of a checkout, by git; without it, all but hidden folders, installed packages and results."""
    if (root / ".git").exists():
        listed = subprocess.run(
            ["git", "ls-files", "-z"], cwd=root, capture_output=True, text=True, check=True
        )
        return [name for name in listed.stdout.split("\0") if name]
    packages = {Path(folder).resolve() for folder in sys.path} - {root.resolve()}
    found = []
    for folder, inner, files in os.walk(root):
        inner[:] = [
            name
            for name in inner
            if name != "__pycache__"
            and not name.startswith(".")
            and (Path(folder) / name).resolve() not in packages
            and not (Path(folder) / name / "faults.jsonl").exists()
        ]
        found += [(Path(folder) / name).relative_to(root).as_posix() for name in files]
    return found
