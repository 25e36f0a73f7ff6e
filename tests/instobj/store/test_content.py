"""The store: results are complete or absent, found by content, verified, and survive interruption."""

import errno
import json
import os
import shutil
import subprocess
import sys
import time
from pathlib import Path

import pytest

from design.errors import InputError, StoreError
from instobj.store import lease, record
from instobj.store.content import stored
from instobj.store.keys import content_key
from instobj.store.record import RECORD


def _write(text: str, calls: list[str] | None = None):
    def make(folder: Path) -> None:
        if calls is not None:
            calls.append(text)
        (folder / "result.txt").write_text(text)

    return make


def test_second_request_reuses_the_first_result(tmp_path):
    calls: list[str] = []
    first = stored(tmp_path, "stage", {"a": 1, "b": [2, 3]}, _write("x", calls))
    again = stored(tmp_path, "stage", {"b": [2, 3], "a": 1}, _write("y", calls))
    assert calls == ["x"]
    assert (first.reused, again.reused) == (False, True)
    assert (again.folder, again.content) == (first.folder, first.content)
    assert (again.folder / "result.txt").read_text() == "x"


@pytest.mark.parametrize("inputs", [{"a": 2}, {"a": "1"}, {"a": 1, "b": None}, {}])
def test_any_other_input_makes_anew(tmp_path, inputs):
    stored(tmp_path, "stage", {"a": 1}, _write("x"))
    assert not stored(tmp_path, "stage", inputs, _write("y")).reused
    assert not stored(tmp_path, "other", {"a": 1}, _write("z")).reused


def _visible(root: Path) -> list[str]:
    return [path.name for path in root.iterdir() if path.name != ".leases"]


@pytest.mark.parametrize("error", [KeyboardInterrupt, StoreError, RuntimeError])
def test_an_interrupted_stage_leaves_nothing_and_earlier_results(tmp_path, error):
    kept = stored(tmp_path, "first", {}, _write("kept"))

    def interrupted(folder: Path) -> None:
        (folder / "half.txt").write_text("half")
        raise error("stopped")

    with pytest.raises(error):
        stored(tmp_path, "second", {}, interrupted)
    assert _visible(tmp_path) == ["first"]
    assert stored(tmp_path, "first", {}, _write("never")).folder == kept.folder
    assert not stored(tmp_path, "second", {}, _write("whole")).reused


def test_a_folder_without_its_record_is_not_a_result(tmp_path):
    first = stored(tmp_path, "stage", {}, _write("x"))
    (first.folder / RECORD).unlink()
    assert not stored(tmp_path, "stage", {}, _write("y")).reused
    assert (first.folder / "result.txt").read_text() == "y"


def test_key_ignores_the_order_of_keys_and_nothing_else():
    assert content_key({"a": 1, "b": 2}) == content_key({"b": 2, "a": 1})
    assert content_key({"a": [1, 2]}) != content_key({"a": [2, 1]})


def test_unwritable_store_is_named(tmp_path):
    blocked = tmp_path / "file"
    blocked.write_text("")
    with pytest.raises(StoreError, match="INSTOBJ_STORE"):
        stored(blocked / "store", "stage", {}, _write("x"))


FILES = {"table.nc": bytes(range(256)) * 40, "rows.json": b'{"a": 1}', "maps/one.png": b"\x89PNG.."}


def _make_files(folder: Path) -> None:
    for name, content in FILES.items():
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_bytes(content)


def _flip(path: Path) -> None:
    content, before = bytearray(path.read_bytes()), path.stat()
    content[len(content) // 2] ^= 1
    path.write_bytes(content)
    os.utime(path, ns=(before.st_atime_ns, before.st_mtime_ns))  # as a failing disk leaves it


def _truncate(path: Path) -> None:
    os.truncate(path, path.stat().st_size // 2)


def _empty(path: Path) -> None:
    os.truncate(path, 0)


@pytest.mark.parametrize("damage", [_flip, _truncate, _empty, Path.unlink])
@pytest.mark.parametrize("name", [*FILES, RECORD])
def test_a_damaged_file_is_set_aside_and_its_result_made_again(tmp_path, name, damage):
    said: list[str] = []
    first = stored(tmp_path, "stage", {"a": 1}, _make_files, said.append)
    damage(first.folder / name)
    again = stored(tmp_path, "stage", {"a": 1}, _make_files, said.append)
    assert (again.reused, again.folder, again.content) == (False, first.folder, first.content)
    assert {one: (again.folder / one).read_bytes() for one in FILES} == FILES
    aside = f"{first.folder.name}.damaged-1"
    assert (first.folder.parent / aside).is_dir()
    (line,) = said
    assert all(word in line for word in ("stage", name, aside))
    assert stored(tmp_path, "stage", {"a": 1}, _write("never")).reused


def test_every_bit_of_the_record_counts(tmp_path):
    first = stored(tmp_path, "stage", {"a": 1}, _make_files)
    whole = (first.folder / RECORD).read_bytes()
    for place in [at for at in range(len(whole)) if not whole[at : at + 1].isspace()]:
        damaged = bytearray(whole)
        damaged[place] ^= 1
        (first.folder / RECORD).write_bytes(damaged)
        with pytest.raises(record.DamagedResult):
            record.read_record(first.folder)


def test_an_added_file_is_damage_too_and_a_hidden_one_is_none(tmp_path):
    first = stored(tmp_path, "stage", {}, _make_files)
    (first.folder / ".nfs0001").write_text("of the file system")
    assert stored(tmp_path, "stage", {}, _make_files).reused
    (first.folder / "maps" / "two.png").write_text("of somebody")
    assert not stored(tmp_path, "stage", {}, _make_files).reused


def test_a_result_copied_to_another_key_is_not_taken_for_it(tmp_path):
    one = stored(tmp_path, "stage", {"a": 1}, _write("one"))
    two = stored(tmp_path, "stage", {"a": 2}, _write("two"))
    shutil.rmtree(two.folder)
    shutil.copytree(one.folder, two.folder)
    assert not stored(tmp_path, "stage", {"a": 2}, _write("two")).reused
    assert (two.folder / "result.txt").read_text() == "two"


def test_sizes_alone_are_compared_where_asked(tmp_path, monkeypatch):
    monkeypatch.setenv("INSTOBJ_STORE_VERIFY", "size")
    first = stored(tmp_path, "stage", {}, _make_files)
    _flip(first.folder / "table.nc")
    assert stored(tmp_path, "stage", {}, _make_files).reused
    _truncate(first.folder / "table.nc")
    assert not stored(tmp_path, "stage", {}, _make_files).reused
    monkeypatch.setenv("INSTOBJ_STORE_VERIFY", "quick")
    with pytest.raises(InputError, match="'quick'"):
        stored(tmp_path, "stage", {}, _make_files)


def test_a_file_is_hashed_once_per_process_unless_it_is_touched(tmp_path, monkeypatch):
    first = stored(tmp_path, "stage", {}, _make_files)
    read: list[str] = []

    def counted(path: Path) -> str:
        read.append(path.name)
        return key_of(path)

    key_of = record.file_key
    monkeypatch.setattr(record, "file_key", counted)
    for _ in range(3):
        assert stored(tmp_path, "stage", {}, _make_files).reused
    assert sorted(read) == sorted(Path(name).name for name in FILES)
    os.utime(first.folder / "rows.json", (1.0, 1.0))
    assert stored(tmp_path, "stage", {}, _make_files).reused
    assert read[len(FILES) :] == ["rows.json"]


def test_all_is_on_the_disk_before_the_result_gets_its_name(tmp_path, monkeypatch):
    flushed: list[tuple[str, bool]] = []
    place = tmp_path / "stage"

    def noted(handle: int) -> None:
        path = Path(os.readlink(f"/proc/self/fd/{handle}"))
        flushed.append((path.name, place.exists()))

    monkeypatch.setattr(os, "fsync", noted)
    stored(tmp_path, "stage", {}, _make_files)
    before = {name for name, named in flushed if not named}
    assert {Path(name).name for name in FILES} | {RECORD, "maps"} <= before
    assert any(name.startswith(".making-") for name in before)
    assert ("stage", True) in flushed


def test_the_result_of_a_process_that_was_quicker_is_taken(tmp_path):
    def slow(folder: Path) -> None:
        stored(tmp_path, "stage", {}, _write("quicker"))
        (folder / "result.txt").write_text("slower")

    result = stored(tmp_path, "stage", {}, slow)
    assert (result.folder / "result.txt").read_text() == "quicker"
    assert result.content == stored(tmp_path, "stage", {}, _write("never")).content


def test_a_full_disk_leaves_nothing_and_says_what_to_do(tmp_path, monkeypatch):
    def full(handle: int) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    with monkeypatch.context() as patch:
        patch.setattr(os, "fsync", full)
        with pytest.raises(StoreError, match="no space left on its disk"):
            stored(tmp_path, "stage", {}, _make_files)
    assert _visible(tmp_path) == []
    assert not stored(tmp_path, "stage", {}, _make_files).reused


def _unfinished_elsewhere(root: Path, seconds_ago: float) -> Path:
    """A running stage of a process on another host, whose last heartbeat was some time ago."""
    lease = root / ".leases" / "0123abcd"
    work = root / ".making-mesh-0123-77.0123abcd"
    work.mkdir(parents=True)
    lease.parent.mkdir(exist_ok=True)
    (work / "half.npz").write_text("half")
    lease.write_text(json.dumps({"host": "elsewhere", "pid": 999_999_999, "started": 1.0}))
    for path in (work, lease):
        os.utime(path, (time.time() - seconds_ago,) * 2)
    return work


def test_work_of_a_live_process_on_another_host_is_left_alone(tmp_path):
    work = _unfinished_elsewhere(tmp_path, seconds_ago=30)
    stored(tmp_path, "stage", {}, _write("x"))
    assert (work / "half.npz").read_text() == "half"
    assert (tmp_path / ".leases" / "0123abcd").exists()


def test_work_without_a_heartbeat_for_a_minute_is_removed(tmp_path):
    work = _unfinished_elsewhere(tmp_path, seconds_ago=90)
    stored(tmp_path, "stage", {}, _write("x"))
    assert not work.exists()
    assert not (tmp_path / ".leases" / "0123abcd").exists()


def test_work_of_a_locked_lease_is_left_alone_though_its_heart_stood_still(tmp_path):
    fcntl = pytest.importorskip("fcntl")
    work = _unfinished_elsewhere(tmp_path, seconds_ago=3600)
    with (tmp_path / ".leases" / "0123abcd").open() as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        stored(tmp_path, "stage", {}, _write("x"))
        assert work.exists()
    stored(tmp_path, "other", {}, _write("x"))
    assert not work.exists()


def test_young_work_is_left_alone_where_its_lease_is_not_seen_yet(tmp_path):
    """A network folder may show a host's work before its lease."""
    work = _unfinished_elsewhere(tmp_path, seconds_ago=30)
    (tmp_path / ".leases" / "0123abcd").unlink()
    stored(tmp_path, "stage", {}, _write("x"))
    assert work.exists()
    os.utime(work, (time.time() - 90,) * 2)
    stored(tmp_path, "other", {}, _write("x"))
    assert not work.exists()


def test_a_process_that_works_touches_its_lease(tmp_path, monkeypatch):
    monkeypatch.setattr(lease, "BEAT_S", 0.01)
    path = lease.hold_lease(tmp_path).path
    os.utime(path, (1.0, 1.0))
    began = time.monotonic()
    while path.stat().st_mtime < 2.0:
        assert time.monotonic() < began + 30.0
        time.sleep(0.01)
    path.unlink()  # which ends its thread


def test_a_killed_process_leaves_its_result_to_the_next(tmp_path):
    """Nothing of it is read; a minute later nothing of it is left."""
    script = (
        "import os, sys\nfrom pathlib import Path\nfrom instobj.store.content import stored\n"
        "def make(folder):\n    (folder / 'half.txt').write_text('half')\n"
        "    os.kill(os.getpid(), 9)\nstored(Path(sys.argv[1]), 'stage', {}, make)"
    )
    done = subprocess.run([sys.executable, "-c", script, tmp_path], check=False)
    assert done.returncode == -9
    (work,) = tmp_path.glob(".making-*")
    assert not stored(tmp_path, "stage", {}, _write("whole")).reused
    assert work.exists()
    for path in (work, *(tmp_path / ".leases").glob(work.name.rsplit(".", 1)[-1])):
        os.utime(path, (time.time() - 90,) * 2)
    stored(tmp_path, "other", {}, _write("x"))
    assert not work.exists()
