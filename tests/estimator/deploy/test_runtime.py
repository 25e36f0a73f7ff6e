"""Readings of a board in the order of a model's channels, and the largest values that parity is told in."""

from collections import deque
from types import SimpleNamespace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.errors import InputError
from estimator.deploy import export, runtime
from estimator.deploy.runtime import channel_readings
from estimator.deploy.zeroing import PAUSE_S
from estimator.frames.face_data import HISTORY


def test_channels_are_found_by_face_sensor_and_axis():
    raw = np.arange(18.0).reshape(2, 3, 3)
    channels = ((1, 0, 0), (2, 2, 1), (HISTORY + 2, 0, 2))
    assert channel_readings(raw, channels).tolist() == [0.0, 16.0, 11.0]


@pytest.mark.parametrize("channel", [(3, 0, 0), (1, 3, 0), (2, 1, 1)])
def test_channels_that_are_not_there_or_mute_are_told_by_name(channel):
    raw = np.zeros((2, 3, 3))
    raw[1, 1, 1] = np.nan
    face, sensor, axis = channel
    with pytest.raises(InputError, match=f"channel F{face}-{'XYZ'[axis]}{sensor + 1}, which"):
        channel_readings(raw, (channel,))


def test_probes_go_from_a_channel_s_noise_to_the_range_of_a_chip():
    counts = export.probe_counts(3)
    assert counts.shape == (64 * 9, 3)
    size = np.sqrt(np.mean(counts.reshape(9, -1) ** 2, axis=1))
    assert_allclose(size, 4.0 ** np.arange(9), rtol=0.2)


def test_sizes_are_the_largest_of_each_scale_s_frames():
    output = np.zeros((576, 2))
    output[3], output[64], output[575] = -5.0, [0.5, np.inf], [2.0, np.nan]
    found = export.output_sizes(output)
    assert found.shape == (576, 1)
    assert found[:64].tolist() == [[5.0]] * 64
    assert found[64:128].tolist() == [[0.5]] * 64
    assert found[-64:].tolist() == [[2.0]] * 64
    assert found[128] == 0


@pytest.fixture
def told(monkeypatch):
    """What a live model is shown; a contact of half its change."""
    shown = []

    def run_model(model, counts):
        shown.append(counts[0].tolist())
        return SimpleNamespace(contact=counts[:, 0] / 2, force_n=counts[:, 0] * 3)

    monkeypatch.setattr(runtime, "run_model", run_model)
    return shown


def reader_of(zero, frames, history):
    channels = ((2, 0, 0), (HISTORY + 2, 0, 1))
    model = SimpleNamespace(channels=channels, history_frames=history)
    reader = object.__new__(runtime.LiveReader)
    reader.__dict__.update(model=model, zero=zero, zero_frames=frames, recent=deque())
    reader.__dict__["last_s"] = np.nan
    reader.rezero()
    return reader


def frame_of(level, past):
    raw = np.full((2, 1, 3), np.nan)
    raw[1, 0, :2] = level, past
    return raw


def test_changes_over_history_are_to_the_frame_so_many_before_and_none_across_a_pause(told):
    """Levels less the zero of the first two frames; the other channel less itself two frames ago."""
    reader = reader_of("first", 2, 2)
    feed = runtime.LiveReader.feed.__wrapped__
    times_s = [5.0, 5.125, 5.25, 5.5, 5.5 + PAUSE_S, 5.625 + 2 * PAUSE_S, 6 + 2 * PAUSE_S]
    levels, past = [10.0, 14, 20, 30, 40, 50, 60], [1.0, 2, 4, 8, 16, 32, 64]
    found = [feed(reader, frame_of(a, b), t) for a, b, t in zip(levels, past, times_s, strict=True)]
    assert found[0] is None
    assert told[-5:] == [[8, 3], [18, 6], [28, 12], [38, 0], [48, 32]]
    reader.miss()  # 64 stands in once more
    feed(reader, frame_of(70.0, 100.0), times_s[-1] + 0.1)
    assert told[-1] == [58, 36]
    for past_now, change in ((200.0, 136), (None, None), (300.0, 100), (400.0, 200)):
        if past_now is None:
            reader.miss()
        else:
            feed(reader, frame_of(12.0, past_now), times_s[-1] + past_now / 1e3)
            assert told[-1] == [0, change]
    reader.rezero()
    assert feed(reader, frame_of(1.0, 2.0), times_s[-1] + 0.2) is None


def test_a_still_change_is_read_without_history(told):
    reader = reader_of("none", 1, 1)
    assert runtime.LiveReader.read_still.__wrapped__(reader, np.array([0.5, 9.0]))[:2] == (
        0.25,
        1.5,
    )
    assert told == [[0.5, 0]]
