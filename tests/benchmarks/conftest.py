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
    """Function name → (result, printed text, folder) of its quick form on some threads."""

    def run(name, threads=1, expected=()):
        done = subprocess.run(
            [sys.executable, str(BENCHMARKS / f"{name}.py"), "--quick", "--out", str(tmp_path)],
            capture_output=True,
            text=True,
            env={**os.environ, "OMP_NUM_THREADS": str(threads), "MKL_NUM_THREADS": str(threads)},
            check=False,
        )
        assert done.returncode == 0, done.stderr
        assert sorted(path.name for path in tmp_path.iterdir()) == sorted(expected)
        return json.loads((tmp_path / f"{name}.json").read_text()), done.stdout

    return run
