"""Frames of a place in levels of like force, and what zeros and drift make of their means."""

import numpy as np
from numpy.testing import assert_allclose, assert_array_equal

from estimator.calibration.twin.like_forces import levels_of_like_force, steady_pieces
from estimator.calibration.twin.pressed_places import drift_rate, drifting_zeros
from tests.support.mechanics.synthetic_presses import coarse_spec

NOISE_N = 0.12


def press_with_stops(rng, stop_frames=60):
    """True and labelled forces of a press with stops at 2 and 6 N."""
    ramp = np.linspace(0.3, 2, 8), np.linspace(2, 6, 12), np.linspace(6, 0.3, 20)
    true = np.concatenate(
        [ramp[0], np.full(stop_frames, 2.0), ramp[1], np.full(stop_frames, 6.0), ramp[2]]
    )
    return true, true + NOISE_N * rng.standard_normal(len(true))


def test_levels_hold_all_frames_and_grow():
    _, label = press_with_stops(np.random.default_rng(1))
    levels = levels_of_like_force(label, np.zeros(len(label), int), NOISE_N, 12)
    assert_array_equal(np.sort(np.concatenate(levels)), np.arange(len(label)))
    assert len(levels) == 12
    assert np.all(np.diff([label[level].mean() for level in levels]) > 0)


def test_labels_of_a_stop_are_not_sorted_by_their_noise():
    """Mean labels err by the noise of a mean, where levels of sorted labels err by that of a frame."""
    errors, sorted_errors = [], []
    for seed in range(20):
        true, label = press_with_stops(np.random.default_rng(seed))
        levels = levels_of_like_force(label, np.zeros(len(label), int), NOISE_N, 12)
        errors += [label[one].mean() - true[one].mean() for one in levels if len(one) > 10]
        parts = np.array_split(np.argsort(label), 12)
        sorted_errors += [label[one].mean() - true[one].mean() for one in parts]
    assert np.std(errors) < 1.3 * NOISE_N / np.sqrt(13)
    assert np.std(sorted_errors) > 2 * np.std(errors)


def test_a_stretch_ends_with_its_press():
    pieces = steady_pieces(np.full(9, 4.0), np.repeat([0, 1], [5, 4]), NOISE_N, 3)
    assert [piece.tolist() for piece in pieces] == [[0, 1, 2], [3, 4], [5, 6], [7, 8]]


def test_as_many_levels_as_frames_allow():
    force = np.full(12, 3.0)
    levels = levels_of_like_force(force, np.zeros(12, int), NOISE_N, 4)
    assert [len(level) for level in levels] == [3, 3, 3, 3]


def test_levels_of_a_steady_rise_hold_equal_numbers():
    rise = levels_of_like_force(np.arange(24.0)[::-1].copy(), np.zeros(24, int), NOISE_N, 4)
    assert [sorted(level.tolist()) for level in rise] == [
        list(range(first, first + 6)) for first in (18, 12, 6, 0)
    ]


def test_drift_between_levels_is_a_random_walk_since_the_zero_of_each_press():
    spec = coarse_spec()
    zeroed, time_s = np.repeat([4, 7], 6), np.concatenate([np.arange(6.0), 100 + np.arange(6.0)])
    levels = [np.array([0, 5, 6]), np.array([1, 2, 8]), np.array([3, 4, 7, 9, 10, 11])]
    since = time_s - np.repeat([0.0, 100.0], 6)
    frames = np.equal.outer(zeroed, zeroed) * (
        drift_rate(spec) * np.minimum.outer(since, since) + spec.sensors.zeroing_counts**2
    )
    weight = np.zeros((3, 12))
    for k, level in enumerate(levels):
        weight[k, level] = 1 / len(level)
    assert_allclose(drifting_zeros(spec, zeroed, time_s, levels), weight @ frames @ weight.T)


def test_errors_of_zeros_that_a_recording_states_are_shared_by_their_memory():
    spec = coarse_spec()
    variance = np.array([9.0, 7.0, 8.0, 12.0, 5.0, 6.0])
    memory = np.array([3.0, 3.1, 3.5, 3.6, 0.0, 0.4])
    session, time_s = np.array([0, 0, 0, 0, 1, 1]), np.arange(6.0)
    order = np.array([2, 0, 5, 3, 1, 4])  # frames may come in any order
    levels = [np.array([0, 3, 5]), np.array([1, 2, 4])]
    wanted = np.zeros((6, 6))
    for a in range(6):
        for b in range(6):
            late = max(a, b)
            alike = variance[late] * np.exp(-abs(memory[a] - memory[b]))
            wanted[a, b] = alike * (session[a] == session[b])
    weight = np.zeros((2, 6))
    for k, level in enumerate(levels):
        weight[k, order[level]] = 1 / len(level)
    error = np.stack([variance, memory], axis=1)[order]
    found = drifting_zeros(spec, session[order], time_s[order], levels, error)
    assert_allclose(found, weight @ wanted @ weight.T)
