"""The checks of recordings on a stream: found within a few frames, without false alarms."""

import numpy as np
import pytest

from estimator.recordings.checks.readings import noisy
from estimator.recordings.checks.stream import SoundReadings

CHIPS = (5, 3)


def resting(frames, seed=0, noise=20.0):
    rng = np.random.default_rng(seed)
    level = rng.uniform(-2000, 2000, (*CHIPS, 3))
    return np.round(level + rng.normal(0, noise, (frames, *CHIPS, 3)))


def left_out(stream):
    sound = SoundReadings()
    return np.array([np.isnan(sound.known(frame)) for frame in stream]), sound


@pytest.mark.parametrize("rate_hz", [50, 200])
def test_a_chip_that_stands_still_is_left_out_within_a_fifth_of_a_second(rate_hz):
    late = []
    for seed in range(4):
        stream = resting(300, seed)
        stream[150:, 2, 1] = stream[149, 2, 1]
        out, sound = left_out(stream)
        late.append(int(out[150:, 2, 1].all(axis=1).argmax()))
        out[150:, 2, 1] = False
        assert out.mean() < 1e-4
        assert "F3-S2" in sound.text
    assert max(late) < 0.2 * rate_hz


def test_a_chip_that_never_moved_is_left_out_once_the_others_show_their_noise():
    stream = resting(62)
    stream[:, 4, 2] = [0.0, 55.0, -3.0]
    out, _ = left_out(stream)
    assert out[12:, 4, 2].all()
    assert not np.delete(out.reshape(62, 15, 3), 14, axis=1).any()


def test_a_chip_that_answers_again_is_believed_at_once():
    stream = resting(200)
    stream[100:140, 0, 0] = 0
    out, _ = left_out(stream)
    assert out[100:140, 0, 0].all()
    assert not out[140:].any()


def test_one_axis_that_stands_still_is_left_out_alone():
    stream = resting(200)
    stream[100:, 1, 2, 0] = stream[99, 1, 2, 0]
    out, _ = left_out(stream)
    assert out[110:, 1, 2, 0].all()
    assert not out[:, 1, 2, 1:].any()


@pytest.mark.parametrize("times", [2, 10])
def test_a_logger_faster_than_its_sensors_raises_no_alarm(times):
    stream = np.repeat(resting(300), times, axis=0)
    out, _ = left_out(stream)
    assert not out.any()


def test_sensors_that_convert_at_other_times_are_believed_after_the_first_seconds():
    stream = resting(400)
    for k in range(15):
        held = np.repeat(stream[:100, k // 3, k % 3], 4, axis=0)
        stream[:, k // 3, k % 3] = np.roll(held, k, axis=0)
    out, _ = left_out(stream)
    assert out[:100].mean() < 0.02
    assert not out[100:].any()


def test_a_board_that_sends_one_frame_over_and_over_is_found():
    stream = resting(200)
    stream[100:] = stream[100]
    out, sound = left_out(stream)
    assert out[125:].all()
    assert sound.text.startswith("all 45 channels")


def test_a_stream_without_noise_is_believed():
    stream = np.zeros((200, *CHIPS, 3))
    stream[100:150] = np.linspace(0, 500, 50)[:, None, None, None]
    assert not left_out(stream)[0].any()


def test_a_channel_that_turns_noisy_is_left_out_within_a_fifth_of_a_second_at_100_hz():
    late, kept, in_file = [], [], []
    for seed in range(4):
        stream, rng = resting(300, seed), np.random.default_rng(100 + seed)
        stream[150:, 2, 1, 0] += np.round(200 * rng.standard_normal(150))
        out, sound = left_out(stream)
        late.append(int(out[150:, 2, 1, 0].argmax()))
        kept.append(out[170:, 2, 1, 0].mean())
        assert "F3-X2: noisy" in sound.text
        in_file.append(noisy(stream)[0][150:, 2, 1, 0].mean())
        out[150:, 2, 1, 0] = False
        assert not out.any()
    assert max(late) <= 20
    assert np.mean(kept) > 0.9
    assert np.mean(in_file) > 0.95


def test_taps_and_sudden_presses_are_no_noise():
    """Taps of 5 Hz at 50 frames a second, and contacts that come and go within a frame."""
    stream, time_s = resting(2000), np.arange(2000) / 50
    taps = 1000 * np.maximum(0, np.sin(2 * np.pi * 2.5 * time_s)) * (time_s > 10)
    stream[:, 1, 0] += np.round(taps[:, None] * [1.0, 0.4, -0.7])
    stream[:, 3, 1] += np.where((np.arange(2000) % 40 < 20) & (time_s > 20), 3000, 0)[:, None]
    assert not left_out(stream)[0].any()
    assert not noisy(stream)[0].any()
