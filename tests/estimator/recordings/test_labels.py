"""Labels that the signals contradict, readings, signs and places that cannot be: each is planted in a sound
recording and found there."""

from dataclasses import replace

import numpy as np
import pytest

from design.errors import InputError, RecordingError
from estimator.recordings.checks.limits import Limits, limit_to_range
from estimator.recordings.checks.place_labels import press_patterns
from estimator.recordings.checks.press_labels import hidden_contacts, silent_presses
from estimator.recordings.formats.files import read_table
from estimator.recordings.formats.netcdf import write_generic_netcdf
from estimator.recordings.formats.text import parse_number
from estimator.recordings.reading import read_recording
from tests.support.recordings.judged_cases import judged, raw_table
from tests.support.recordings.made_recordings import (
    PRESS,
    REST,
    RISE,
    gripper_arrays,
    write_gripper,
)

CASES = ((54, 57), (23, 28), (75, 76))
LABEL_FAULTS = {
    "contact while labelled rest",
    "force without signal",
    "wrong place label",
    "jumping channel",
    "shell moved",
}
SIGNS_AND_LIMITS = {
    "force turned",
    "channel turned",
    "channels exchanged",
    "place off the body",
    "count beyond the chip's range",
}
HELD = REST + RISE + 10


@pytest.fixture(scope="module")
def arrays():
    return gripper_arrays(CASES, presses=4, lag=0)


@pytest.fixture
def read(tmp_path):
    def read_arrays(arrays, cases=CASES, **given):
        return read_recording(write_gripper(tmp_path / "a.csv", arrays, cases), **given)

    return read_arrays


def copies(arrays):
    return [array.copy() for array in arrays]


def found(recording, kind):
    return [fault for fault in recording.report.faults if fault.kind == kind]


def rows(press, first=0, last=PRESS):
    return slice(press * PRESS + first, press * PRESS + last)


def used(recording, press):
    part = rows(press)
    loaded = recording.frames.place_id[part] >= 0
    return bool((recording.frames.valid[part] & loaded).any())


def test_a_sound_recording_has_none_of_them(read, arrays):
    recording = read(arrays)
    assert not {fault.kind for fault in recording.report.faults} & (LABEL_FAULTS | SIGNS_AND_LIMITS)
    assert all(used(recording, press) for press in range(12))


def test_a_wrong_place_is_found_by_the_other_presses_of_both_places(read, arrays):
    planted = copies(arrays)
    planted[3][rows(1)] = 2
    recording = read(planted)
    (fault,) = found(recording, "wrong place label")
    assert fault.where == f"rows {PRESS}–{2 * PRESS - 1}"
    assert "labelled face 3 (7.5, 1.5) + face 5 (7.5, -1.5)" in fault.detail
    assert "responds like face 3 (1.5, 4.5) + face 5 (1.5, -4.5)" in fault.detail
    assert [used(recording, press) for press in range(12)] == [press != 1 for press in range(12)]


@pytest.mark.parametrize("cell", [0, 1])
def test_a_force_without_signal(read, arrays, cell):
    planted = copies(arrays)
    face = (2, 4)[cell]
    quiet = planted[2][rows(6, 0, 15), face].mean(axis=0)
    noise = np.random.default_rng(2).normal(0, 20, (PRESS, 9))
    planted[2][rows(6), face] = np.round(quiet + noise)
    recording = read(planted)
    (fault,) = found(recording, "force without signal")
    assert fault.where == f"rows {6 * PRESS}–{7 * PRESS - 1}"
    assert f"on face {(3, 5)[cell]}" in fault.detail
    assert not used(recording, 6)
    assert used(recording, 7)


def test_a_press_that_the_load_cells_did_not_feel(read, arrays):
    """The cable of both cells out for one press: signals move in frames called rest."""
    planted = copies(arrays)
    planted[1][rows(4)] = 0.0
    recording = read(planted)
    faults = found(recording, "contact while labelled rest")
    assert len(faults) == 1
    first, last = (int(text) for text in faults[0].where.removeprefix("rows ").split("–"))
    assert 4 * PRESS + REST <= first < 4 * PRESS + REST + RISE
    assert 5 * PRESS - REST - RISE < last < 5 * PRESS - REST
    assert not recording.frames.valid[first : last + 1].any()
    rest = recording.frames.valid[rows(5)] & (recording.frames.place_id[rows(5)] < 0)
    shown = recording.frames.signal_counts[rows(5)][rest]
    np.testing.assert_allclose(np.nanmean(shown, axis=0), 0, atol=15)


def test_a_force_where_the_label_says_no_contact(read, arrays):
    planted = copies(arrays)
    planted[3][rows(3)] = 3
    recording = read(planted, (*CASES, (0, 101)))
    fault = found(recording, "contact while labelled rest")[0]
    assert fault.where.startswith("rows 4")
    assert not used(recording, 3)
    assert used(recording, 2)


def test_a_force_in_a_generic_recording_where_no_place_is_stated(arrays, tmp_path):
    table = read_table(write_gripper(tmp_path / "a.csv", arrays, CASES))
    unstated = rows(7, REST + 20, REST + 40)
    table.tip_xy_mm[unstated], table.face[unstated] = np.nan, 0
    write_generic_netcdf(table, tmp_path / "a.nc")
    recording = read_recording(tmp_path / "a.nc")
    (fault,) = found(recording, "contact while labelled rest")
    assert fault.where == f"rows {7 * PRESS + REST + 20}–{7 * PRESS + REST + 39}"
    assert not used(recording, 7)


def test_a_channel_that_jumps_between_two_presses(read, arrays):
    planted = copies(arrays)
    planted[2][5 * PRESS - 2 :, 3, 4] += 2750
    recording = read(planted)
    (fault,) = found(recording, "jumping channel")
    assert fault.where == "F4-Y2, before press 5"
    assert np.isnan(recording.frames.signal_counts[:, 3, 1, 1]).all()
    assert np.isfinite(np.delete(recording.frames.signal_counts.reshape(-1, 45), 31, axis=1)).all()


def test_patterns_are_unit_means_of_five_frames_of_half_the_press_and_more(read, arrays):
    recording = read(copies(arrays))
    press, place, pattern = press_patterns(recording.frames)
    assert len(press) == len(place) == len(pattern) == len(np.unique(press))
    assert np.allclose(np.sqrt(np.nansum(pattern**2, axis=1)), 1)
    none = replace(recording.frames, valid=np.zeros(len(recording.frames), bool))
    press, place, pattern = press_patterns(none)
    channels = recording.frames.signal_counts[0].size
    assert (press.shape, place.shape, pattern.shape) == ((0,), (0,), (0, channels))


@pytest.mark.parametrize(
    ("sigmas", "frames", "at_rest", "told"),
    [
        (6.1, 5, 40, True),
        (5.9, 5, 40, False),
        (-6.1, 5, 40, True),
        (6.1, 4, 40, False),
        (6.1, 5, 14, False),
        (6.1, 5, 15, True),
    ],
)
def test_a_hidden_contact_leaves_its_level_by_six_sigmas_in_five_frames(
    sigmas, frames, at_rest, told
):
    """Of face 4, most channels of which change; its noise is twice that of the others."""
    noise = np.ones((5, 3, 3))
    noise[3] = 2.0
    counts = np.full((50, 5, 3, 3), 100.0)
    counts[5 : 5 + frames, 3, :2] += 2.0 * sigmas
    rest, none = np.arange(50) < at_rest, np.zeros((50, 1))
    case = judged(none[:, 0].astype(int), none, counts=counts, rest=rest, noise_counts=noise)
    hidden, faults = hidden_contacts(case)
    assert np.flatnonzero(hidden).tolist() == (list(range(5, 5 + frames)) if told else [])
    assert [fault.detail[:6] for fault in faults] == (["face 4"] if told else [])


@pytest.mark.parametrize(
    ("counts", "sigma", "newton", "told"),
    [
        (9.9, 19.9, 2.0, True),
        (10.1, 19.9, 2.0, False),
        (9.9, 20.1, 2.0, False),
        (9.9, 19.9, 4.0, True),
        (19.9, 19.9, 4.0, True),
        (0.0, 1.0, 0.31, True),
        (0.0, 1.0, 0.29, False),
    ],
)
def test_a_press_is_silent_below_a_tenth_of_what_is_usual_where_that_stands_out(
    counts, sigma, newton, told
):
    """Of five presses of 2 N on face 3, where 50 counts per newton are usual, the fourth is another."""
    force_n = np.where(np.arange(60) % 12 < 6, 0.0, 2.0)[:, None]  # not held before half of a press
    force_n[36:48] *= newton / 2.0
    press = np.repeat(np.arange(5), 12)
    responses = np.full((5, 5), 7.0)
    responses[:, 2] = [100.0, 100.0, 100.0, counts, 100.0]
    noise = np.full((5, 3, 3), sigma)
    noise[1, 1, 1] = np.nan
    face = np.full((60, 1), 3)
    case = judged(press, force_n, face=face, responses=responses, noise_counts=noise)
    wrong, faults = silent_presses(case)
    assert np.flatnonzero(wrong).tolist() == (list(range(36, 48)) if told else [])
    assert len(faults) == told


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


def test_readings_that_wrapped_round_faster_than_the_bound_are_left_out(read, arrays):
    """A chip of 16 bits near one end, which a press drives out by it: counts come in by the other."""
    near, planted = copies(arrays), copies(arrays)
    channel = near[2][:, 2, 4]
    channel[:5] = channel.max()  # it begins beyond the range
    near[2][:, 2, 4] += np.round(32_767 - np.sort(channel)[-40])
    planted[2][:, 2, 4] = (near[2][:, 2, 4] + 32_768) % 65_536 - 32_768
    wrapped = planted[2][:, 2, 4] != near[2][:, 2, 4]
    assert wrapped.sum() > 3
    recording = read(planted)
    (fault,) = found(recording, "counts wrapped round")
    assert fault.where.startswith("F3-Y2, rows")
    assert fault.detail.startswith(f"{wrapped.sum()} readings")
    used = recording.frames.valid & ~wrapped
    seen = recording.frames.signal_counts[:, 2, 4 // 3, 4 % 3]
    assert np.nanmax(np.abs(seen)) < 10_000
    assert np.isfinite(seen[used]).any()
    assert not found(read(arrays), "counts wrapped round")


def test_readings_that_wrapped_round_slowly_are_undone_and_stay_so_when_read_again(read, arrays):
    near, planted = copies(arrays), copies(arrays)
    channel, row = near[2][:, 2, 4], np.arange(len(near[2]))
    channel += np.round(32_767 - channel.max() + 6_000 * np.exp(-(((row - 200) / 6.0) ** 2)))
    planted[2][:, 2, 4] = (channel + 32_768) % 65_536 - 32_768
    wrapped = planted[2][:, 2, 4] != channel
    assert wrapped.sum() > 3
    (fault,) = found(read(planted), "counts wrapped round")
    assert fault.action == "undone"
    again, once = read(near), read(planted)
    assert not found(again, "counts wrapped round") + found(again, "count beyond the chip's range")
    np.testing.assert_array_equal(once.frames.signal_counts, again.frames.signal_counts)


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
