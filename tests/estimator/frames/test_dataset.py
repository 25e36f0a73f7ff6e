"""Data sets of labelled frames: files, parts, and what is refused."""

from dataclasses import fields, replace

import h5py
import numpy as np
import pytest
from numpy.testing import assert_array_equal

from design.errors import InputError, StoreError
from estimator.frames.dataset import PER_FRAME_FIELDS, load_frames, save_frames
from tests.support.recordings.synthetic_frames import synthetic_frames


@pytest.fixture(scope="module")
def frames():
    made = synthetic_frames(presses=1, places=[0, 7], rest=2, loaded=3)
    made.signal_counts[:, 3, 2] = np.nan
    return replace(made, valid=np.arange(len(made)) % 3 > 0, lag_frames=8, source="recorded")


def test_round_trip(frames, tmp_path):
    path = tmp_path / "deep" / "signals.nc"
    save_frames(frames, path)
    loaded = load_frames(path)
    for field in fields(frames):
        before, after = getattr(frames, field.name), getattr(loaded, field.name)
        if field.name == "signal_counts":
            before = before.astype(np.float32)
        assert_array_equal(after, before)
    assert list(path.parent.iterdir()) == [path]


def test_units_and_dimensions_are_in_the_file(frames, tmp_path):
    save_frames(frames, tmp_path / "a.nc")
    with h5py.File(tmp_path / "a.nc") as file:
        assert file["signal_counts"].attrs["unit"] == "count"
        assert file["force_n"].attrs["unit"] == "N"
        assert {"frame", "face", "sensor", "axis", "contact"} <= set(file)
        assert file.attrs["schema_version"] == 1


def test_select_by_mask_and_by_index(frames):
    mask = frames.contact_face[:, 0] == 4
    picked = frames.select(mask)
    assert len(picked) == mask.sum()
    again = frames.select(np.flatnonzero(mask)[::-1].copy())
    for name in PER_FRAME_FIELDS:
        assert_array_equal(getattr(picked, name), getattr(frames, name)[mask])
        assert_array_equal(getattr(again, name)[::-1], getattr(picked, name))
    assert_array_equal(picked.grid_x_mm, frames.grid_x_mm)


def test_missing_file(tmp_path):
    with pytest.raises(InputError, match="no labelled frames at"):
        load_frames(tmp_path / "none.nc")


@pytest.mark.parametrize("content", [b"", b"not a data set", b"\x89HDF\r\n\x1a\n" + b"\0" * 200])
def test_foreign_file(tmp_path, content):
    (tmp_path / "bad.nc").write_bytes(content)
    with pytest.raises(StoreError, match=r"bad\.nc"):
        load_frames(tmp_path / "bad.nc")


def test_truncated_file(frames, tmp_path):
    save_frames(frames, tmp_path / "a.nc")
    content = (tmp_path / "a.nc").read_bytes()
    (tmp_path / "a.nc").write_bytes(content[: len(content) // 2])
    with pytest.raises(StoreError, match="Make it anew"):
        load_frames(tmp_path / "a.nc")


@pytest.mark.parametrize("change", ["version", "variable", "attribute"])
def test_other_schema(frames, tmp_path, change):
    save_frames(frames, tmp_path / "a.nc")
    with h5py.File(tmp_path / "a.nc", "a") as file:
        if change == "version":
            file.attrs["schema_version"] = 99
        elif change == "variable":
            del file["press_id"]
        else:
            del file.attrs["seed"]
    with pytest.raises(StoreError, match="schema 1"):
        load_frames(tmp_path / "a.nc")


def test_a_folder_is_not_a_data_set(tmp_path):
    with pytest.raises(InputError, match="no labelled frames at"):
        load_frames(tmp_path)


def test_faces_that_never_spoke_are_left_out(frames):
    quiet = replace(frames, signal_counts=frames.signal_counts.copy())
    quiet.signal_counts[:, [0, 1, 3, 4]] = np.nan
    pressed = set(np.unique(frames.contact_face).tolist()) - {0}
    alone = replace(quiet, contact_face=np.where(frames.contact_face > 0, 3, 0))
    only = alone.select_faces((3,))
    assert (only.faces.tolist(), only.signal_counts.shape[1]) == ([3], 1)
    assert_array_equal(only.signal_counts[:, 0], alone.signal_counts[:, 2])
    assert frames.select_faces((3,)) is frames, "others speak"
    assert pressed == {3} or quiet.select_faces((3,)) is quiet, "others are pressed"
