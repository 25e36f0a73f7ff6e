"""The store: results are complete or absent, found by content, and survive interruption."""

from pathlib import Path

import pytest

from design.errors import StoreError
from instobj.store.content import RECORD, content_key, stored


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
    assert again.folder == first.folder
    assert (again.folder / "result.txt").read_text() == "x"


@pytest.mark.parametrize("inputs", [{"a": 2}, {"a": "1"}, {"a": 1, "b": None}, {}])
def test_any_other_input_makes_anew(tmp_path, inputs):
    stored(tmp_path, "stage", {"a": 1}, _write("x"))
    assert not stored(tmp_path, "stage", inputs, _write("y")).reused
    assert not stored(tmp_path, "other", {"a": 1}, _write("z")).reused


@pytest.mark.parametrize("error", [KeyboardInterrupt, StoreError, RuntimeError])
def test_an_interrupted_stage_leaves_nothing_and_earlier_results(tmp_path, error):
    kept = stored(tmp_path, "first", {}, _write("kept"))

    def interrupted(folder: Path) -> None:
        (folder / "half.txt").write_text("half")
        raise error("stopped")

    with pytest.raises(error):
        stored(tmp_path, "second", {}, interrupted)
    assert [path.name for path in tmp_path.iterdir()] == ["first"]
    assert stored(tmp_path, "first", {}, _write("never")).folder == kept.folder
    assert not stored(tmp_path, "second", {}, _write("whole")).reused


def test_leftovers_of_a_killed_process_are_removed(tmp_path):
    dead = tmp_path / ".making-mesh-0123-999999999"
    dead.mkdir()
    (dead / "half.npz").write_text("half")
    stored(tmp_path, "stage", {}, _write("x"))
    assert not dead.exists()


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
