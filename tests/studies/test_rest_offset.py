"""Contact cases guessed from rest levels alone, beside what is worked out by hand."""

from types import SimpleNamespace

import numpy as np
import pytest

from design.errors import InputError
from estimator.recordings.reading import Recording
from studies.recorded.rest_offset import rest_offset_baseline

A, B, C = (((1, 0.0, 0.0),), ((1, 3.0, 0.0),), ((2, 0.0, 0.0),))


def recording(cases, levels, dead):
    """Presses of three frames, the first at rest, with one more press that touches nothing."""
    places = tuple(dict.fromkeys(cases))
    ids = [[-1, places.index(case), places.index(case)] for case in cases]
    counts = np.full((len(cases) + 1, 5, 3, 3), 100.0)
    counts[:-1, 2, 1, :2] += levels
    counts[:, 4, 0, dead] = np.nan
    made = object.__new__(Recording)
    frames = SimpleNamespace(
        press_id=np.repeat(np.arange(len(cases) + 1), 3), place_id=np.ravel([*ids, [-1] * 3])
    )
    object.__setattr__(made, "frames", frames)
    object.__setattr__(made, "report", SimpleNamespace(places=places))
    object.__setattr__(made, "rest_counts", counts)
    return made


@pytest.mark.parametrize(("share", "judged"), [(0.6, 5), (0.9, 3), (0.1, 8)])
def test_cases_are_guessed_by_the_nearest_mean_level_of_other_presses(share, judged):
    """Five presses of A, four of B and two of C, which are unlike: one of them rests as A does."""
    at_a, at_b = [10.0, 0.0], [20.0, 0.0]
    recordings = [
        recording([B, A, A, B, A], [at_b, at_a, at_a, at_b, at_a], 0),
        recording([C, B, A, C, A, B], [[10.1, 0.0], at_b, at_a, [0.0, 10.0], at_a, at_b], 2),
    ]
    for seed in (1, 2):
        found = rest_offset_baseline(recordings, seed, share)
        assert found.presses == judged
        assert found.accuracy == pytest.approx(1 - 1 / judged)
        assert found.chance == pytest.approx(1 / 3)


def test_a_case_that_was_pressed_once_cannot_be_guessed():
    with pytest.raises(InputError, match="contact case 1 has one press"):
        rest_offset_baseline([recording([B, A, A], [[0.0, 0.0]] * 3, 0)], 1)
