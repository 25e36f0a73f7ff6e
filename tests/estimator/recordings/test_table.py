"""Values that no recording holds are refused at their border, and told what they should be."""

from dataclasses import replace

import numpy as np
import pytest

from design.errors import RecordingError
from estimator.recordings.table import channel_name, check_plausible, check_signals
from tests.support.recordings.judged_cases import raw_table

FRAMES = 5
SOUND = raw_table(
    FRAMES,
    force_n=np.ones((FRAMES, 1)),
    counts=np.ones((FRAMES, 5, 1, 3)),
    face=np.full((FRAMES, 1), 3),
    tip_xy_mm=np.full((FRAMES, 1, 1, 2), 2.0),
)


def with_value(name, value):
    values = np.array(getattr(SOUND, name) if name != "shear_n" else np.zeros((FRAMES, 1, 2)))
    values[(-1,) * values.ndim] = value
    return replace(SOUND, **{name: values})


@pytest.mark.parametrize(
    ("name", "largest", "says"),
    [
        ("counts", 2.0**24, "raw counts of the sensors"),
        ("shear_n", 1000.0, "forces in N"),
        ("tip_xy_mm", 300.0, "places in mm"),
    ],
)
@pytest.mark.parametrize("sign", [1, -1])
def test_the_largest_value_is_taken_and_a_larger_one_refused(name, largest, says, sign):
    check_plausible(with_value(name, sign * largest))
    check_plausible(with_value(name, np.nan))
    with pytest.raises(RecordingError, match=says):
        check_plausible(with_value(name, sign * largest * 1.0001))


@pytest.mark.parametrize("sign", [1, -1])
def test_forces_of_another_unit_are_refused_and_single_ones_left_to_the_checks(sign):
    check_plausible(with_value("force_n", sign * 8e4))
    check_plausible(replace(SOUND, force_n=np.full(SOUND.force_n.shape, sign * 1000.0)))
    with pytest.raises(RecordingError, match="forces in N, not in g or mN"):
        check_plausible(replace(SOUND, force_n=np.full(SOUND.force_n.shape, sign * 1000.1)))


def test_places_of_less_than_a_tenth_of_a_millimetre_are_metres():
    small = np.full((FRAMES, 1, 1, 2), 0.02)
    with pytest.raises(RecordingError, match=r"within 0\.02 mm of"):
        check_plausible(replace(SOUND, tip_xy_mm=small))
    check_plausible(replace(SOUND, tip_xy_mm=5 * small))
    check_plausible(replace(SOUND, tip_xy_mm=0 * small))
    check_plausible(replace(SOUND, tip_xy_mm=np.nan * small))


def test_stamps_in_milliseconds_are_refused():
    check_plausible(replace(SOUND, time_s=1e11 - np.arange(FRAMES)[::-1] / 10))
    check_plausible(replace(SOUND, time_s=np.zeros(0)))
    with pytest.raises(RecordingError, match="Give seconds, not ms"):
        check_plausible(replace(SOUND, time_s=1.0001e11 + np.arange(FRAMES) / 10))
    with pytest.raises(RecordingError, match="s apart"):
        check_plausible(replace(SOUND, time_s=5.0 * np.arange(FRAMES)))
    check_plausible(replace(SOUND, time_s=4.99 * np.arange(FRAMES)))
    check_plausible(replace(SOUND, time_s=np.array([0.0, 60.0])))
    with pytest.raises(RecordingError, match="s apart"):
        check_plausible(replace(SOUND, time_s=np.array([0.0, 60.0, 120.0])))


def test_channels_are_named_by_face_axis_and_number():
    assert channel_name(0, 0, 0) == "F1-X1"
    assert channel_name(4, 2, 1) == "F5-Y3"


def test_rows_from_last_to_first_are_refused_and_a_single_step_back_is_not():
    with pytest.raises(RecordingError, match="backwards from row to row in 4 of 4 steps"):
        check_plausible(replace(SOUND, time_s=SOUND.time_s[::-1]))
    check_plausible(replace(SOUND, time_s=np.array([0.0, 0.1, 0.2, 0.0, 0.1])))


def in_whole_seconds(*parts):
    """Stamps of four frames a second."""
    return np.repeat(np.concatenate(parts).astype(float), 4)


def test_rows_in_reverse_order_among_others_are_refused_and_clocks_started_anew_are_not():
    """They would be as many presses as the clock steps back."""
    check_signals(in_whole_seconds([5, 6], [0, 1], [8, 9], [2, 3]), SOUND.counts)
    check_signals(in_whole_seconds([0, 1, 2, 9, 8, 7, 10]), SOUND.counts)  # two steps back on end
    with pytest.raises(
        RecordingError, match=r"from data row 16 to 25, in 3 steps .* Sort the rows"
    ):
        check_signals(in_whole_seconds([0, 1, 2, 9, 8, 7, 6, 10]), SOUND.counts)
    with pytest.raises(RecordingError, match="from data row 4 to 17, in 4 steps"):
        check_signals(in_whole_seconds([4, 3, 2, 1, 0]), SOUND.counts)


@pytest.mark.parametrize("pair", [0, 17, 38])
def test_two_rows_that_exchanged_places_are_refused(pair):
    stamps = np.arange(40) / 10 + 0.02 * np.random.default_rng(1).random(40)
    swapped = stamps.copy()
    swapped[[pair, pair + 1]] = stamps[[pair + 1, pair]]
    check_signals(stamps, SOUND.counts)
    with pytest.raises(RecordingError, match=rf"^1 pair .* rows {pair + 1} and {pair + 2}\."):
        check_signals(swapped, SOUND.counts)


def test_a_clock_set_back_by_a_little_has_no_rows_exchanged():
    """By less than two frames, so that its next stamp lies between the two before, and by a whole session."""
    for back in (0.13, 0.19, 2.0):
        stamps = np.arange(40) / 10
        stamps[20:] -= back
        check_signals(stamps, SOUND.counts)
    check_signals(
        np.array([0.0, 0.1, 0.3, 0.2, 0.3, 0.4, 0.5]), SOUND.counts
    )  # a frame lost before
