"""Runs and searches that are killed at any moment, full disks, two hosts: nothing stored is lost.

Slow. `INSTOBJ_KILLS` sets how often (100).
"""

import multiprocessing
import os
import random
import shutil
import subprocess
import sys
import time
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path
from typing import Any

import pytest

from design.errors import InstobjError
from design.spec.object import ObjectSpec
from instobj.search.trials import open_trials
from instobj.stages.run import Run
from instobj.store.space import entries
from tests.support.objects.search_cases import (
    kept_lines,
    made_up_score,
    made_up_space,
    searched,
)

pytestmark = pytest.mark.slow

KILLS = int(os.environ.get("INSTOBJ_KILLS", "100"))
SPEC = ObjectSpec.model_validate(
    {
        "name": "tiny",
        "body": {"sensed_faces": [1]},
        "contact_grid": {"count": [3, 3], "pitch_mm": 6.0},
        "press": {"depths_mm": [1.0, 2.0]},
        "mesh": {"edge_mm": 8.0, "surface_edge_mm": 3.0, "rim_edge_ratio": 1.0},
        "score": {"force_n": 2.0},
    }
)
BEGIN = ("mesh", "large_strain")
"""Kept from the first run: the mesher gives another mesh each time, and all later results with it."""
DISKS_KIB = (0, 32, 128, 256, 512)
HEAD_RECORDS = 1
"""Lines of a file of trials, before its first one."""
SEARCH = {"trials": 1_000_000}

CHILDREN = multiprocessing.get_context("forkserver")
"""Children begin with everything imported, in a few milliseconds."""
CHILDREN.set_forkserver_preload([__name__])


def _run_chain(store: Path) -> None:
    Run(SPEC, root=store).require("scores")


def _run_search(journal: Path) -> None:
    searched(journal, **SEARCH)


def contents(store: Path) -> dict[str, str]:
    run = Run(SPEC, root=store)
    run.require("scores")
    return {stage: result.content for stage, result in run.results.items()}


def _in_child(work: Callable[..., Any], *arguments: Any) -> Any:
    """As a user's process does it: without what the tests change in theirs."""
    with ProcessPoolExecutor(1, CHILDREN) as pool:
        return pool.submit(work, *arguments).result()


def _begun(first: Path, store: Path) -> Path:
    for stage in BEGIN:
        shutil.copytree(first / stage, store / stage)
    return store


@pytest.fixture(scope="module")
def first(tmp_path_factory):
    """A store with a whole run, and the content of its results."""
    store = tmp_path_factory.mktemp("first") / "store"
    return store, _in_child(contents, store)


def assert_nothing_is_lost(store: Path, expected: dict[str, str]) -> None:
    """What is stored is whole, and the next run keeps it and gives the same."""
    kept = entries(store, by_hash=True)
    assert {entry.state for entry in kept} <= {"result"}
    assert _in_child(contents, store) == expected
    assert {entry.folder for entry in kept} <= {entry.folder for entry in entries(store)}


def test_killed_runs_lose_nothing_and_the_next_run_gives_the_same(first, tmp_path):
    begun, expected = first
    timed = CHILDREN.Process(target=_run_chain, args=(_begun(begun, tmp_path / "timed"),))
    began = time.perf_counter()
    timed.start()
    timed.join()
    whole_s = time.perf_counter() - began
    assert timed.exitcode == 0
    moments, broken_off, held = random.Random(1), 0, set()
    for number in range(KILLS):
        store = _begun(begun, tmp_path / f"store_{number}")
        process = CHILDREN.Process(target=_run_chain, args=(store,))
        process.start()
        time.sleep(moments.uniform(0.0, whole_s))
        process.kill()
        process.join()
        broken_off += process.exitcode != 0
        held.add(len(entries(store)))
        assert_nothing_is_lost(store, expected)
        shutil.rmtree(store)
    print(f"{broken_off} of {KILLS} runs were broken off, with {sorted(held)} results kept")
    assert broken_off >= KILLS // 2  # else too little was killed to show anything
    assert len(held) > 2


def test_killed_searches_lose_no_kept_trial_and_go_on(tmp_path):
    moments, kept_in_all = random.Random(2), 0
    for number in range(KILLS):
        journal = tmp_path / f"search_{number}" / "trials.jsonl"
        journal.parent.mkdir()
        process = CHILDREN.Process(target=_run_search, args=(journal,))
        process.start()
        while not kept_lines(journal):
            time.sleep(0.001)
        time.sleep(moments.uniform(0.0, 0.5))
        before = kept_lines(journal)
        process.kill()
        process.join()
        trials = open_trials(made_up_space(**SEARCH).spec, journal, resume=True).trials
        assert len(trials) >= before - HEAD_RECORDS
        assert not any(trial.failure for trial in trials)
        for trial in trials:
            (made_up,) = made_up_score([trial.params], 0)
            assert trial.values == made_up.values
        wanted = len(trials) + 8
        again = searched(journal, **(SEARCH | {"trials": wanted})).trials
        assert len(again) == wanted
        assert [t.params for t in again[: len(trials)]] == [t.params for t in trials]
        kept_in_all += len(trials)
    print(f"{KILLS} searches killed with {kept_in_all} trials kept, none lost")
    assert kept_in_all > KILLS


@pytest.mark.skipif(
    sys.platform != "linux" or os.geteuid() != 0, reason="mounts a small disk: root on Linux"
)
@pytest.mark.parametrize("kib", DISKS_KIB)
def test_a_full_disk_is_one_clear_error_and_with_room_the_run_goes_on(first, tmp_path, kib):
    begun, expected = first
    size = sum(f.stat().st_size for stage in BEGIN for f in (begun / stage).rglob("*"))
    disk = tmp_path / "disk"
    disk.mkdir()
    options = f"size={size // 1024 + 64 + kib}k"
    subprocess.run(["mount", "-t", "tmpfs", "-o", options, "tmpfs", disk], check=True)
    try:
        store = _begun(begun, disk / "store")
        with pytest.raises(InstobjError, match="room"):
            _in_child(contents, store)
        subprocess.run(["mount", "-o", "remount,size=1g", disk], check=True)
        assert_nothing_is_lost(store, expected)
    finally:
        subprocess.run(["umount", "--lazy", disk], check=True)


APART = ("unshare", "--pid", "--uts", "--fork", "--mount-proc")
HOST = """
import socket, sys
from pathlib import Path
from tests.chain import test_kill
socket.sethostname(sys.argv[2])
print(sorted(test_kill.contents(Path(sys.argv[1])).items()))
"""


@pytest.mark.skipif(
    sys.platform != "linux" or os.geteuid() != 0, reason="makes namespaces: root on Linux"
)
def test_two_hosts_share_a_store(first, tmp_path):
    """Own process numbers and host names: both finish, with the same content, and nothing is left."""
    begun, expected = first
    store = _begun(begun, tmp_path / "shared")
    hosts = [
        subprocess.Popen(
            [*APART, sys.executable, "-c", HOST, str(store), name],
            stdout=subprocess.PIPE,
            text=True,
            cwd=Path(__file__).parents[2],
        )
        for name in ("first", "second")
    ]
    said = [host.communicate()[0] for host in hosts]
    assert [host.returncode for host in hosts] == [0, 0]
    assert said == [f"{sorted(expected.items())}\n"] * 2
    assert {entry.state for entry in entries(store, by_hash=True)} == {"result"}
