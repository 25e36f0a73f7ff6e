"""Recordings joined by hand: ids that go on, slots that are padded, channels that jumped."""

from types import SimpleNamespace

import numpy as np
import pytest
from numpy.testing import assert_array_equal

from design.errors import InputError
from estimator.frames.dataset import FrameSet
from estimator.recordings import combine as module
from estimator.recordings.reading import Recording

A, B, C = ((3, 1.0, 2.0),), ((3, 4.0, 5.0),), ((4, 0.0, 0.0),)
NAN = np.nan


def recording(name, places, place_id, slots=1, rest=0.0, **changes):
    count = len(place_id)
    given = {
        "signal_counts": np.ones((count, 5, 1, 3)),
        "contact_face": np.full((count, slots), 3),
        "contact_xy_mm": np.ones((count, slots, 2)),
        "force_n": np.ones((count, slots, 3)),
        "valid": np.ones(count, bool),
        "press_id": np.arange(count),
        "place_id": np.array(place_id),
        "session_id": np.arange(count) // 2,
        "time_s": np.arange(count) / 10,
        "faces": np.arange(1, 6),
        "grid_x_mm": np.arange(2.0),
        "grid_y_mm": np.arange(2.0),
        "noise_counts": np.array([1.0, 2.0, 3.0]),
        "source": "recorded",
        "spec_hash": name,
        "seed": 0,
    }
    frames = FrameSet(**{**given, **changes})
    made = object.__new__(Recording)
    rest_counts = np.full((2, 5, 1, 3), float(rest))
    made.__dict__.update(frames=frames, report=SimpleNamespace(places=places))
    made.__dict__.update(rest_counts=rest_counts)
    return made


def test_ids_go_on_and_places_are_those_of_all_recordings():
    one = recording("a", (A, C), [0, 1, -1], lag_frames=2, noise_counts=np.array([1.0, 2, 3]))
    two = recording("b", (B, C), [1, 0], slots=2, lag_frames=5, noise_counts=np.array([3.0, 2, 9]))
    found = module.combine([one, two])
    assert found.press_id.tolist() == [0, 1, 2, 3, 4]
    assert found.session_id.tolist() == [0, 0, 1, 2, 2]
    assert found.place_id.tolist() == [0, 2, -1, 2, 1]
    assert found.contact_face.tolist() == [[3, 0], [3, 0], [3, 0], [3, 3], [3, 3]]
    assert np.isnan(found.contact_xy_mm[:3, 1]).all()
    assert np.isnan(found.force_n[:3, 1]).all()
    assert (found.spec_hash, found.lag_frames) == ("a+b", 4)
    assert found.noise_counts.tolist() == [2.0, 2.0, 6.0]
    assert found.zero_error is None
    assert module.combine([one]).spec_hash == "a"


def test_errors_of_zeros_are_kept_where_all_have_them():
    errors = np.ones((2, 2))
    both = [recording(name, (A,), [0, 0], zero_error=errors) for name in "ab"]
    assert module.combine(both).zero_error.shape == (4, 2)
    one = [both[0], recording("c", (A,), [0, 0])]
    assert module.combine(one).zero_error is None


def test_channels_whose_rest_jumped_are_emptied_and_told():
    one, two, three = (recording(name, (A,), [0, 0]) for name in "abc")
    two.rest_counts[:, 1, 0, 2] = 501.0
    three.rest_counts[:, 4, 0, 0] = 500.0
    found = module.combine([one, two, three])
    assert np.isnan(found.signal_counts[:, 1, 0, 2]).all()
    assert np.isfinite(found.signal_counts).sum() == 6 * 14
    (fault,) = module.faults_between([one, two, three])
    assert str(fault) == (
        "jumping channel: F2-Z1, between the recordings: rest level 0 → 501 → 0 counts; set to NaN"
    )
    assert not module.jumps_between([two, two]).any()


def test_what_does_not_belong_together_is_refused():
    one = recording("a", (A,), [0, 0])
    for given in ([], [one, one], [one, recording("b", (A,), [0, 0], grid_x_mm=np.arange(3.0))]):
        with pytest.raises(InputError):
            module.combine(given)
    wide = recording("b", (A,), [0, 0])
    wide.__dict__["rest_counts"] = np.zeros((2, 5, 2, 3))
    with pytest.raises(InputError):
        module.jumps_between([one, wide])
    assert_array_equal(module.jumps_between([one]), np.zeros((5, 1, 3), bool))
