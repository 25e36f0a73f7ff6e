"""Space in the store: listed, verified, and freed without what is in use."""

import json
import os
import time
from pathlib import Path

import pytest

from instobj.store.content import stored
from instobj.store.record import RECORD
from instobj.store.space import entries, free
from tests.support.cli import assert_one_clear_error, run

_DAY_S = 86_400


def _make(size: int):
    def make(folder: Path) -> None:
        (folder / "table.nc").write_bytes(b"x" * size)

    return make


def _aged(root: Path, stage: str, days: float, size: int = 1000) -> Path:
    """A result that was last used some days ago."""
    folder = stored(root, stage, {"days": days}, _make(size)).folder
    os.utime(folder / RECORD, (time.time() - days * _DAY_S,) * 2)
    return folder


def _end_this_process(root: Path) -> None:
    """Leases of what was made above, as when its process had ended."""
    for lease in (root / ".leases").glob("*"):
        lease.unlink()


def _elsewhere(root: Path, began_days_ago: float, beat_s_ago: float) -> None:
    lease = root / ".leases" / "0123abcd"
    now = time.time()
    lease.write_text(json.dumps({"host": "elsewhere", "started": now - began_days_ago * _DAY_S}))
    os.utime(lease, (now - beat_s_ago,) * 2)


def test_the_least_recently_used_goes_first_and_no_more_than_asked(tmp_path):
    old, older, new = (_aged(tmp_path, "stage", days) for days in (20, 30, 10))
    _end_this_process(tmp_path)
    removed = free(tmp_path, lambda entry: True, least_bytes=1500)
    assert [entry.folder for entry in removed] == [older, old]
    assert not old.exists()
    assert not older.exists()
    assert [entry.folder for entry in entries(tmp_path)] == [new]


def test_use_is_what_counts_not_when_it_was_made(tmp_path):
    first, second = _aged(tmp_path, "stage", 30), _aged(tmp_path, "stage", 20)
    assert stored(tmp_path, "stage", {"days": 30}, _make(1)).folder == first
    assert [entry.folder for entry in entries(tmp_path)] == [second, first]


def test_what_is_set_aside_goes_before_any_result(tmp_path):
    _aged(tmp_path, "stage", 30)
    damaged = stored(tmp_path, "other", {}, _make(10)).folder
    (damaged / "table.nc").unlink()
    stored(tmp_path, "other", {}, _make(10))
    _end_this_process(tmp_path)
    (removed,) = free(tmp_path, lambda entry: True, least_bytes=1)
    assert removed.state == "set aside"


@pytest.mark.parametrize(
    ("began_days_ago", "beat_s_ago", "kept"), [(15, 30, 10), (15, 90, None), (5, 30, None)]
)
def test_what_a_live_process_has_used_since_it_began_stays(
    tmp_path, began_days_ago, beat_s_ago, kept
):
    folders = {days: _aged(tmp_path, "stage", days) for days in (20, 10)}
    _end_this_process(tmp_path)
    _elsewhere(tmp_path, began_days_ago, beat_s_ago)
    free(tmp_path, lambda entry: True, None)
    assert [folder for folder in folders.values() if folder.exists()] == (
        [] if kept is None else [folders[kept]]
    )


def test_what_this_process_has_used_stays(tmp_path):
    stored(tmp_path, "stage", {}, _make(10))
    assert free(tmp_path, lambda entry: True, None) == []


def test_the_command_lists_and_frees_by_age(tmp_path):
    store = tmp_path / ".instobj"
    _aged(store, "mesh", 40, 2000)
    kept = _aged(store, "scores", 3)
    _end_this_process(store)
    listed = json.loads(run("store", "--json", cwd=tmp_path).stdout)
    assert [row["stage"] for row in listed["entries"]] == ["mesh", "scores"]
    assert all(row["state"] == "result" for row in listed["entries"])
    done = run("store", "--free", "30d", "--json", cwd=tmp_path)
    freed = json.loads(done.stdout)
    assert [row["stage"] for row in freed["freed"]] == ["mesh"]
    assert freed["freed_bytes"] > 2000
    assert [row["folder"] for row in freed["entries"]] == [str(kept)]
    assert "scores" in run("store", cwd=tmp_path).stdout


def test_the_command_finds_a_flipped_bit_and_says_so(tmp_path):
    folder = stored(tmp_path / ".instobj", "mesh", {}, _make(100)).folder
    (folder / "table.nc").write_bytes(b"x" * 99 + b"y")
    assert run("store", cwd=tmp_path).returncode == 0
    done = run("store", "--verify", cwd=tmp_path)
    assert done.returncode == 1
    assert "table.nc holds other bytes" in " ".join(done.stdout.split())


@pytest.mark.parametrize(
    ("words", "said"),
    [(("--free", "5 apples"), "5GB"), (("--free", "soon"), "30d"), ((), "INSTOBJ_STORE")],
)
def test_what_cannot_be_read_is_one_error(tmp_path, words, said):
    if words:
        (tmp_path / ".instobj").mkdir()
    assert_one_clear_error(run("store", *words, cwd=tmp_path), said)


def test_results_of_an_earlier_version_are_named_and_go_first(tmp_path):
    _aged(tmp_path, "stage", 30)
    earlier = tmp_path / "mesh" / "0123456789"
    earlier.mkdir(parents=True)
    (earlier / RECORD).write_text('{"stage": "mesh", "key": "0123456789", "seconds": 1.0}')
    os.utime(earlier / RECORD, (time.time() - 20 * _DAY_S,) * 2)
    _end_this_process(tmp_path)
    assert {entry.stage: entry.state for entry in entries(tmp_path)} == {
        "stage": "result",
        "mesh": "earlier version",
    }
    (removed,) = free(tmp_path, lambda entry: True, least_bytes=1)
    assert removed.folder == earlier


def test_what_another_process_begins_to_use_while_space_is_freed_is_put_back(tmp_path):
    folder = _aged(tmp_path, "stage", 30)
    _end_this_process(tmp_path)

    def used_now(entry) -> bool:
        os.utime(entry.folder / RECORD)
        return True

    assert free(tmp_path, used_now, None) == []
    assert (folder / "table.nc").stat().st_size == 1000
    assert stored(tmp_path, "stage", {"days": 30}, _make(1)).reused
