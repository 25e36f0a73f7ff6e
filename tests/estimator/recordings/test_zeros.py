"""Which frames at rest a press is zeroed from, by hand: every frame counts as its own number."""

import numpy as np
import pytest

from design.errors import RecordingError
from estimator.recordings.zeros import rest_levels


def zeroed(loaded, press, rest=None):
    """Mean number of the frames that each press is zeroed from, and whether they lie before it."""
    numbers = np.arange(len(loaded), dtype=float)[:, None, None, None] * np.ones((1, 5, 1, 3))
    found = rest_levels(numbers, press, loaded, ~loaded if rest is None else rest)
    assert (np.ptp(found.counts, axis=(1, 2, 3)) == 0).all()
    return found.counts[:, 0, 0, 0].tolist(), found.is_before.tolist()


def loads(frames, *ranges):
    loaded = np.zeros(frames, bool)
    for first, last in ranges:
        loaded[first:last] = True
    return loaded


def test_a_press_is_zeroed_from_the_twenty_rest_frames_before_its_first_loaded_one():
    loaded, press = loads(70, (30, 40)), np.zeros(70, int)
    assert zeroed(loaded, press) == ([np.mean(range(10, 30))], [True])
    rest = ~loaded
    rest[28:30] = False
    assert zeroed(loaded, press, rest) == ([np.mean(range(8, 28))], [True])


@pytest.mark.parametrize(
    ("first", "expected"), [(5, (2.0, True)), (4, (np.mean(range(9, 29)), False))]
)
def test_five_frames_before_are_enough_and_four_are_not(first, expected):
    loaded = loads(60, (first, first + 5))
    (level,), (before,) = zeroed(loaded, np.zeros(60, int))
    assert (level, before) == expected


def test_without_rest_before_or_behind_the_last_frames_at_rest_serve():
    loaded = loads(40, (3, 17), (37, 40))
    press = np.repeat([0, 1], [35, 5])
    loaded[:3] = True
    assert zeroed(loaded, press) == (
        [np.mean(range(17, 37)), np.mean(range(17, 37))],
        [False, True],
    )
    late = loads(44, (0, 40))
    rest = ~late
    rest[10:16] = True
    assert zeroed(late, np.repeat([0, 1], [5, 39]), rest)[0][0] == np.mean(
        [*range(10, 16), 40, 41, 42, 43]
    )
    assert zeroed(loads(30, (0, 2), (27, 29)), np.repeat([0, 1], [26, 4]))[1] == [False, True]


def test_few_rest_frames_behind_give_way_to_the_last_of_the_recording():
    loaded = loads(20, (0, 5), (12, 17))
    rest = ~loaded
    rest[3:5] = True  # two before the second press's own load, too few
    press = np.repeat([0, 1], [12, 8])
    rest[5:12] = False
    rest[17:] = True
    # rest: 3, 4, 17, 18, 19 — five in all; the second press has two before and three behind
    assert zeroed(loaded, press, rest)[0][1] == np.mean([3, 4, 17, 18, 19])


def test_a_stretch_without_a_press_is_zeroed_from_its_own_end():
    loaded = loads(60, (40, 50))
    level, before = zeroed(loaded, np.repeat([0, 1], [30, 30]))
    assert (level[0], before[0]) == (np.mean(range(10, 30)), True)


def test_five_frames_at_rest_are_needed_in_all():
    loaded = loads(20, (0, 16))
    with pytest.raises(RecordingError, match="at rest"):
        zeroed(loaded, np.zeros(20, int))
    loaded[15] = False
    assert zeroed(loaded, np.zeros(20, int)) == ([17.0], [False])
