"""Simulated calibration presses: labels, disturbances, forces, clamping, determinism."""

from dataclasses import fields, replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.errors import InputError
from design.layout.places.contact_grid import contact_grid
from estimator.frames.dataset import load_frames, save_frames
from estimator.frames.press_protocol import (
    nominal_peaks,
    plan_presses,
    simulate_presses,
    with_nuisances,
)
from estimator.signals.interpolation import counts_at_force, press_traces
from estimator.signals.presses import press_signals
from tests.support.mechanics.synthetic_presses import coarse_spec, force_n, synthetic_presses

PROTOCOL = {"presses_per_place": 3, "frames_per_press": (6, 20)}
SPEC = coarse_spec(protocol=PROTOCOL, seed=4)
QUIET_SENSORS = {"noise_counts": (1e-6, 1e-6, 1e-6), "zeroing_counts": 0, "drift_counts": 0}


@pytest.fixture(scope="module")
def signals():
    return press_signals(SPEC, *synthetic_presses(SPEC))


@pytest.fixture(scope="module")
def frames(signals):
    return simulate_presses(SPEC, signals, "hash")


def test_every_place_is_pressed_as_the_protocol_says(frames):
    assert len(frames) == 5 * 20 * 3 * 26
    pressed = frames.contact_face[:, 0] > 0
    cases, counts = np.unique(frames.place_id[pressed], return_counts=True)
    assert cases.tolist() == [1000 * face + place for face in range(1, 6) for place in range(20)]
    assert (counts == 60).all()
    np.testing.assert_array_equal(frames.place_id[pressed] // 1000, frames.contact_face[pressed, 0])
    assert (frames.place_id[~pressed] == -1).all()
    assert np.isnan(frames.force_n[~pressed]).all()
    assert np.isnan(frames.contact_xy_mm[~pressed]).all()
    assert_allclose(np.diff(frames.time_s), 1 / 10.5)


def test_a_press_shares_its_id_with_its_rest_and_labels_the_nominal_place(frames):
    one = frames.select(frames.press_id == 73)
    assert len(one) == 26
    assert (one.contact_face[:6] == 0).all()
    assert (one.contact_face[6:] == one.contact_face[6]).all()
    assert len(np.unique(one.session_id)) == 1
    place = one.place_id[-1] % 1000
    assert_allclose(one.contact_xy_mm[6:, 0], np.tile(contact_grid(SPEC).xy_mm[place], (20, 1)))
    assert (one.force_n[6:, 0, :2] == 0).all()


def test_nuisances_are_those_of_a_press_and_spread_as_their_deviations(frames):
    """Rest and contact of a press are turned alike; presses are not."""
    columns = np.random.default_rng(2).normal(0, 50, (5, 3, 3, 4))
    added = with_nuisances(frames, columns, 1).signal_counts - frames.signal_counts
    added = added.reshape(300, 26, 45)
    assert_allclose(added, np.repeat(added[:, :1], 26, axis=1), atol=1e-9)
    expected = np.linalg.norm(columns.reshape(45, 4), axis=1)
    # deviations of 300 draws scatter by 4 %
    assert_allclose(added[:, 0].std(axis=0), expected, rtol=0.2)
    assert np.linalg.matrix_rank(added[:, 0], tol=1e-6) == 4


def test_common_travel_brings_the_median_place_to_the_middle_of_the_range(signals):
    peaks = nominal_peaks(SPEC, signals)
    faces = np.arange(1, 6)[:, None]
    exact = force_n(faces, contact_grid(SPEC).xy_mm[None], peaks.common_travel_mm)
    assert_allclose(np.median(exact), 15.0, rtol=2e-3)
    assert_allclose(peaks.force_n, np.clip(exact, 10, 20), rtol=5e-3)
    assert_allclose(nominal_peaks(SPEC, signals).depth_mm, peaks.common_travel_mm, rtol=5e-3)
    assert not peaks.clamped.any()
    narrow = coarse_spec(protocol={**PROTOCOL, "peak_force_n": (14.0, 15.0)})
    assert nominal_peaks(narrow, signals).force_n.max() == 15.0
    assert nominal_peaks(narrow, signals).depth_mm.std() > 0.05


@pytest.mark.parametrize("beyond_n", [-0.5, 0.5])
def test_the_common_travel_ends_at_the_deepest_press(signals, beyond_n):
    """The median place bears the middle of the range in depth, or all the depth that there is."""
    faces, xy, deepest = np.arange(1, 6)[:, None], contact_grid(SPEC).xy_mm[None], 4.0
    most = float(np.median(force_n(faces, xy, deepest)))
    wanted = (most + beyond_n - 1, most + beyond_n + 1)
    spec = coarse_spec(protocol={**PROTOCOL, "peak_force_n": wanted})
    travel = nominal_peaks(spec, signals).common_travel_mm
    assert_allclose(np.median(force_n(faces, xy, travel)), most + min(beyond_n, 0.0), rtol=2e-3)


def test_without_disturbances_frames_are_the_interpolated_signals(signals):
    still = coarse_spec(
        protocol={**PROTOCOL, "lateral_jitter_mm": 0, "force_noise_n": 0}, sensors=QUIET_SENSORS
    )
    frames = simulate_presses(still, signals, "hash")
    pressed = frames.contact_face[:, 0] > 0
    some = np.flatnonzero(pressed)[::97]
    x, y = frames.contact_xy_mm[some, 0].T
    traces = press_traces(signals, frames.contact_face[some, 0], x, y)
    expected = counts_at_force(traces, frames.force_n[some, :, 2]).counts[:, 0]
    found = frames.signal_counts[some].reshape(len(some), -1)
    assert_allclose(found, expected, atol=0.5 + 1e-3)
    assert_allclose(frames.signal_counts[~pressed], 0, atol=0.5 + 1e-3)
    shifted = counts_at_force(traces, 0.8 * frames.force_n[some, :, 2]).counts[:, 0]
    assert abs(found - shifted).max() > 50


def test_rest_frames_carry_noise_and_the_zeroing_error_of_their_press(frames):
    rest = frames.signal_counts[frames.contact_face[:, 0] == 0].reshape(300, 6, 45)
    within = rest.std(axis=1, ddof=1)
    white = np.sqrt((within**2).mean(axis=0)).reshape(15, 3).mean(axis=0)
    assert_allclose(white, [22, 22, 11], rtol=0.03)
    means = rest.mean(axis=1).reshape(300, 15, 3)
    expected = np.sqrt(10**2 + np.array([22, 22, 11]) ** 2 / 6)
    assert_allclose(means.std(axis=(0, 1)), expected, rtol=0.04)
    together = np.corrcoef(means.reshape(300, 45).T) - np.eye(45)
    assert abs(together).max() < 0.3


def test_drift_walks_to_its_rms_in_fifteen_minutes(signals):
    wild = coarse_spec(
        protocol={**PROTOCOL, "frames_per_press": (60, 20)},
        sensors={"noise_counts": (1e-3,) * 3, "zeroing_counts": 0, "drift_counts": 6000},
    )
    frames = simulate_presses(wild, signals, "hash")
    rest = frames.signal_counts[frames.contact_face[:, 0] == 0].reshape(300, 60, 45)
    assert_allclose((rest[:, -1] - rest[:, 0]).std(), 6000 * np.sqrt(59 / 10.5 / 900), rtol=0.02)


def test_forces_rise_and_fall_once_with_their_own_peaks_and_label_noise(signals, frames):
    plan = plan_presses(SPEC, signals)
    nominal = nominal_peaks(SPEC, signals).force_n[plan.face - 1, plan.place]
    assert_allclose((plan.peak_force_n / nominal).min(), 0.9, atol=0.005)
    assert_allclose((plan.peak_force_n / nominal).max(), 1.1, atol=0.005)
    xy = contact_grid(SPEC).xy_mm[plan.place]
    jitter = np.stack([plan.x_mm, plan.y_mm], axis=1) - xy
    assert 0.29 < abs(jitter).max() <= 0.3
    assert abs(jitter.mean()) < 0.02
    force = frames.force_n[:, 0, 2].reshape(300, 26)[:, 6:]
    assert_allclose(force.max(axis=1), plan.peak_force_n, rtol=0.05)
    rising = force[:, 1:9] - force[:, :8]
    assert (rising > -0.6).all()
    exact = simulate_presses(
        SPEC.model_copy(
            update={"protocol": SPEC.protocol.model_copy(update={"force_noise_n": 0.0})}
        ),
        signals,
        "hash",
    ).force_n[:, 0, 2]
    assert_allclose(np.nanstd(frames.force_n[:, 0, 2] - exact), 0.12, rtol=0.03)
    used = frames.valid & (frames.contact_face[:, 0] > 0)
    label = frames.force_n[:, 0, 2]
    assert label[used].min() > 0.3
    assert np.nanmax(label[~frames.valid]) <= 0.3


def test_peaks_beyond_reach_are_clamped_and_counted(signals):
    """Where the deepest press stays below the least peak; those that just reach it are not counted."""
    strong = coarse_spec(protocol={**PROTOCOL, "peak_force_n": (28.0, 60.0)})
    peaks, plan = nominal_peaks(strong, signals), plan_presses(strong, signals)
    assert peaks.common_travel_mm == 4.0
    assert 0 < peaks.clamped.sum() < peaks.clamped.size
    np.testing.assert_array_equal(peaks.clamped, peaks.force_n < 28.0)
    reach = press_traces(signals, plan.face, plan.x_mm, plan.y_mm).force_n[:, -1]
    assert (plan.peak_force_n <= reach).all()
    assert plan.summary()["clamped_presses"] == plan.clamped.sum() > 60
    frames = simulate_presses(strong, signals, "hash")
    assert np.nanmax(frames.force_n) < reach.max() + 0.7


def test_saturated_channels_stay_at_full_scale(signals):
    limit = abs(signals.baseline_counts).max() + 40
    narrow = coarse_spec(protocol=PROTOCOL, sensors={"range_mt": limit / 820})
    frames = simulate_presses(narrow, signals, "hash")
    reading = frames.signal_counts + signals.baseline_counts.reshape(5, 3, 3)
    assert_allclose(abs(reading).max(), np.floor(limit), rtol=1e-12)


def test_seed_fixes_all_frames_and_files_keep_them(signals, frames, tmp_path):
    again = simulate_presses(SPEC, signals, "hash")
    other = simulate_presses(SPEC.model_copy(update={"seed": 5}), signals, "hash")
    np.testing.assert_array_equal(again.signal_counts, frames.signal_counts)
    assert abs(other.signal_counts - frames.signal_counts).max() > 20
    save_frames(frames, tmp_path / "frames.nc")
    back = load_frames(tmp_path / "frames.nc")
    for field in fields(frames):
        found, kept = getattr(back, field.name), getattr(frames, field.name)
        if isinstance(kept, np.ndarray) and kept.dtype == float:
            assert_allclose(found, kept, rtol=1e-6, atol=1e-3)
        else:
            np.testing.assert_array_equal(found, kept)


def test_too_much_jitter_is_refused(signals):
    loose = coarse_spec(protocol={**PROTOCOL, "lateral_jitter_mm": 2.5})
    with pytest.raises(InputError, match=r"lateral_jitter_mm"):
        simulate_presses(loose, replace(signals), "hash")


def test_relaxing_silicone_gives_hysteresis_in_force_and_none_in_the_signals(signals):
    quiet = {"sensors": QUIET_SENSORS, "protocol": PROTOCOL | {"force_noise_n": 0.0}, "seed": 4}
    elastic = simulate_presses(coarse_spec(**quiet), signals, "hash")
    prony = ((0.2, 0.8),)
    relaxed = simulate_presses(coarse_spec(**quiet, silicone={"prony": prony}), signals, "hash")
    np.testing.assert_array_equal(relaxed.signal_counts, elastic.signal_counts)
    shape = (5 * 20 * 3, 26)
    before = elastic.force_n[:, 0, 2].reshape(shape)[:, 6:]
    after = relaxed.force_n[:, 0, 2].reshape(shape)[:, 6:]
    share = after / before
    rising, falling = slice(3, 9), slice(12, 17)
    assert (share[:, rising] < 1).all()
    assert (share[:, rising] > 0.8).all()
    assert (share[:, falling].max(axis=1) < share[:, rising].min(axis=1)).all()
    assert (after >= 0).all()
