"""Benchmarks run as their users run them."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

BENCHMARKS = Path(__file__).parents[2] / "benchmarks"


@pytest.fixture
def quick_run(tmp_path):
    """Function name → (result, printed text) of its quick form on some threads."""

    def run(name, threads=1, expected=(), arguments=()):
        out = tmp_path / "out"
        script = str(BENCHMARKS / f"{name}.py")
        done = subprocess.run(
            [sys.executable, script, *map(str, arguments), "--quick", "--out", str(out)],
            capture_output=True,
            text=True,
            env={**os.environ, "OMP_NUM_THREADS": str(threads), "MKL_NUM_THREADS": str(threads)},
            check=False,
        )
        assert done.returncode == 0, done.stderr
        assert sorted(path.name for path in out.iterdir()) == sorted(expected)
        return json.loads((out / f"{name}.json").read_text()), done.stdout

    return run
