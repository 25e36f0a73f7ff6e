"""Readings, signs and places that cannot be: each is planted in a sound recording and found there."""

import numpy as np
import pytest

from design.errors import InputError, RecordingError
from estimator.recordings.checks.limits import Limits, limit_to_range
from estimator.recordings.formats.text import parse_number
from estimator.recordings.reading import read_recording
from tests.support.recordings.judged_cases import raw_table
from tests.support.recordings.made_recordings import (
    PRESS,
    REST,
    RISE,
    gripper_arrays,
    write_gripper,
)

CASES = ((54, 57), (23, 28), (75, 76))
HELD = REST + RISE + 10


@pytest.fixture(scope="module")
def arrays():
    return gripper_arrays(CASES, presses=4, lag=0)


@pytest.fixture
def read(tmp_path):
    def read_arrays(arrays, **given):
        return read_recording(write_gripper(tmp_path / "a.csv", arrays, CASES), **given)

    return read_arrays


def copies(arrays):
    return [array.copy() for array in arrays]


def found(recording, kind):
    return [fault for fault in recording.report.faults if fault.kind == kind]


@pytest.mark.parametrize("row", [PRESS + HELD, PRESS + 3])
def test_one_count_that_the_chip_cannot_give_costs_one_frame(read, arrays, row):
    """Under load, and in the rest from which the press is zeroed."""
    planted = copies(arrays)
    planted[2][row, 2, 4] = 123_456
    recording, sound = read(planted), read(arrays)
    (fault,) = found(recording, "count beyond the chip's range")
    assert fault.where == f"F3-Y2, rows {row}–{row}"
    assert "123456" in fault.detail
    lost = np.flatnonzero(sound.frames.valid & ~recording.frames.valid)
    assert set(lost) <= {row}
    used = recording.frames.valid
    np.testing.assert_allclose(
        recording.frames.signal_counts[used], sound.frames.signal_counts[used], atol=20
    )


def test_a_specification_narrows_the_range(read, arrays):
    planted = copies(arrays)
    planted[2][PRESS + HELD, 2, 4] = 9_000
    assert not found(read(planted), "count beyond the chip's range")
    narrow = Limits(largest_count=8_000.0, farthest_mm=21.0)
    assert found(read(planted, limits=narrow), "count beyond the chip's range")


def test_a_channel_mostly_beyond_the_range_is_an_error(read, arrays):
    planted = copies(arrays)
    planted[2][:, 2, 4] += 40_000
    with pytest.raises(InputError, match=r"F3-Y2 reaches 4\d{4} counts, beyond ±32768"):
        read(planted)


@pytest.mark.parametrize("cell", [0, 1])
def test_forces_turned_in_some_rows_are_turned_back(read, arrays, cell):
    planted = copies(arrays)
    planted[1][PRESS + HELD : 3 * PRESS, cell] *= -1
    recording, sound = read(planted), read(arrays)
    faults = found(recording, "force turned")
    assert len(faults) == 2
    assert faults[0].where.startswith(f"rows {PRESS + HELD}–")
    np.testing.assert_allclose(recording.frames.force_n, sound.frames.force_n, atol=0.02)
    np.testing.assert_array_equal(recording.frames.valid, sound.frames.valid)


def test_a_channel_whose_sign_turns_between_presses_is_left_out(read, arrays):
    planted = copies(arrays)
    middle = np.median(planted[2][:, 4, 6])
    planted[2][2 * PRESS :, 4, 6] = 2 * middle - planted[2][2 * PRESS :, 4, 6]
    recording = read(planted)
    (fault,) = found(recording, "channel turned")
    assert fault.where == f"F5-X3, rows {2 * PRESS - 1}–{2 * PRESS}"
    assert np.isnan(recording.frames.signal_counts[:, 4, 2, 0]).all()
    assert not found(recording, "wrong place label")


def test_a_sound_recording_has_none_of_them(read, arrays):
    kinds = {fault.kind for fault in read(arrays).report.faults}
    assert not kinds & {"force turned", "channel turned", "channels exchanged"}
    assert not kinds & {"place off the body", "count beyond the chip's range"}


def test_a_press_off_the_body_is_not_used(tmp_path):
    """The outermost place of this recording, of its third case, lies at 10.5 mm."""
    cases = (*CASES[:2], (85, 86))
    path = write_gripper(tmp_path / "a.csv", gripper_arrays(cases, presses=4, lag=0), cases)
    small = Limits(largest_count=32_768.0, farthest_mm=9.0)
    recording = read_recording(path, limits=small)
    faults = found(recording, "place off the body")
    assert {fault.where for fault in faults} == {f"rows {8 * PRESS}–{12 * PRESS - 1}"}
    assert not recording.frames.valid[8 * PRESS :].any()
    assert recording.frames.valid[: 8 * PRESS].any()


@pytest.mark.parametrize("cell", ["1_0", "１２", "٣", "0x1", "ten"])
def test_what_only_python_takes_for_a_number_is_none(cell):
    with pytest.raises(ValueError, match=r"number|convert"):
        parse_number(cell)
    assert parse_number("-1.5e3") == -1500.0
    assert np.isnan(parse_number(""))


def table_of(counts):
    counts = np.tile(np.asarray(counts, float)[:, None, None, None], (1, 5, 3, 3))
    return raw_table(len(counts), counts=counts)


@pytest.mark.parametrize(
    ("frames", "beyond", "sound"), [(40, 2, True), (40, 3, False), (10, 1, True), (10, 2, False)]
)
def test_one_reading_in_twenty_may_be_beyond_the_chip_s_range(frames, beyond, sound):
    """A single one always; a reading at the limit is within it."""
    counts = np.zeros(frames)
    counts[:beyond], counts[-1] = -101.0, 100.0
    limits = Limits(100.0, 50.0)
    if sound:
        clean, faults = limit_to_range(table_of(counts), limits)
        assert np.isnan(clean.counts[:beyond]).all()
        assert np.isfinite(clean.counts[beyond:]).all()
        assert len(faults) == 45
    else:
        with pytest.raises(RecordingError, match=f"in {beyond} of {frames} readings"):
            limit_to_range(table_of(counts), limits)
