"""A run that is killed at any moment loses no stored result, and the next run gives the same."""

import os
import random
import shutil
import subprocess
import sys
import time
from pathlib import Path

import pytest

from design.spec.object import ObjectSpec
from instobj.stages.run import Run
from instobj.store.space import entries

KILLS = 20
SPEC = ObjectSpec.model_validate(
    {
        "name": "tiny",
        "body": {"sensed_faces": [1]},
        "contact_grid": {"count": [3, 3], "pitch_mm": 6.0},
        "press": {"depths_mm": [1.0, 2.0]},
        "mesh": {"edge_mm": 8.0, "surface_edge_mm": 3.0},
        "score": {"force_n": 2.0},
    }
)
SCRIPT = """
import sys
from design.spec.object import ObjectSpec
from instobj.stages.run import Run
run = Run(ObjectSpec.model_validate_json(sys.argv[1]))
print("begins", flush=True)
run.require("scores")
"""
BEGIN = ("mesh", "large_strain")
"""Kept from the first run: the mesher gives another mesh each time, and all later results with it."""


def _started(store: Path) -> subprocess.Popen[str]:
    """A process that runs the chain, past its imports."""
    process = subprocess.Popen(
        [sys.executable, "-c", SCRIPT, SPEC.model_dump_json()],
        env=os.environ | {"INSTOBJ_STORE": str(store)},
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
    )
    assert process.stdout is not None
    assert process.stdout.readline() == "begins\n"
    return process


def _begun(first: Path, store: Path) -> Path:
    for stage in BEGIN:
        shutil.copytree(first / stage, store / stage)
    return store


def _contents(store: Path) -> dict[str, str]:
    run = Run(SPEC, root=store)
    run.require("scores")
    return {stage: result.content for stage, result in run.results.items()}


@pytest.mark.slow
def test_twenty_killed_runs_lose_nothing_and_the_next_run_gives_the_same(tmp_path):
    first = tmp_path / "first"
    expected = _contents(first)
    timed = _started(_begun(first, tmp_path / "timed"))
    began = time.perf_counter()
    assert timed.wait() == 0
    whole_s = time.perf_counter() - began
    moments, broken_off = random.Random(1), 0
    for number in range(KILLS):
        store = _begun(first, tmp_path / f"store_{number}")
        process = _started(store)
        time.sleep(moments.uniform(0.0, 0.8 * whole_s))
        process.kill()
        broken_off += process.wait() != 0
        kept = entries(store, by_hash=True)
        assert {entry.state for entry in kept} == {"result"}
        assert _contents(store) == expected
        assert {entry.folder for entry in kept} <= {entry.folder for entry in entries(store)}
        shutil.rmtree(store)
    assert broken_off >= KILLS // 4  # else too little was killed to show anything
