"""Attitude of an object that lies, is turned, falls and is hit, by the columns of its IMU."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from estimator.recordings.attitude import GRAVITY_M_S2, read_motion, recorded_motion


def turned(rate_rad_s, seconds, hertz=100.0, start=(0.0, 0.0, -1.0)):
    """Stamps, columns and true weight of an object that turns with a constant rate."""
    time_s = np.arange(0, seconds, 1 / hertz)
    rate = np.array(rate_rad_s)
    down = Rotation.from_rotvec(-time_s[:, None] * rate).apply(np.array(start))
    motion = np.hstack([-GRAVITY_M_S2 * down, np.tile(rate, (len(time_s), 1))])
    return time_s, motion, down


def test_the_weight_is_followed_through_a_turn_that_shakes():
    """Half a turn in 2 s, with a hand's acceleration of 4 m/s² in between: the gyroscope bridges it."""
    time_s, motion, down = turned((0.8, 1.2, -0.6), 2.0)
    shaken = (time_s > 0.3) & (time_s < 1.7)
    motion[shaken, 0] += 4.0 * np.sign(np.sin(20 * time_s[shaken])) + 12.0
    recorded = recorded_motion(time_s, motion)
    error_deg = np.degrees(np.arccos(np.clip(np.sum(recorded.down * down, axis=1), -1, 1)))
    assert error_deg.max() < 3.0


def test_a_wrong_start_is_forgotten_and_a_biased_rate_does_not_run_away():
    time_s, motion, _ = turned((0.0, 0.0, 0.0), 60.0, 20.0)
    motion[:, 3] += 0.02
    recorded = recorded_motion(time_s, motion)
    assert np.degrees(np.arccos(-recorded.down[-1, 2])) < 2.0  # 69 degrees by the rate alone


def test_jolts_are_specific_force_off_gravity_and_silence_stays_unknown():
    time_s, motion, _ = turned((0.0, 0.0, 0.0), 1.0)
    motion[40:50, :3] = 0.0  # falls
    motion[50, :3] = (0.0, 0.0, 60.0)  # lands
    motion[:10] = np.nan
    recorded = recorded_motion(time_s, motion)
    assert np.isnan(recorded.down[:10]).all()
    assert recorded.jolt_m_s2[45] == pytest.approx(GRAVITY_M_S2)
    assert recorded.jolt_m_s2[50] == pytest.approx(60 - GRAVITY_M_S2)
    assert "50.2 m/s² beyond gravity at 0.5 s" in recorded.text


def test_the_pull_is_the_weight_with_what_acceleration_adds():
    """1 g along +x for half a second; then silence, in which the last attitude stands."""
    time_s, motion, down = turned((0.0, 0.0, 0.0), 2.0)
    pushed, silent = (time_s >= 0.5) & (time_s < 1.0), time_s > 1.5
    motion[pushed, 0] += GRAVITY_M_S2
    motion[silent] = np.nan
    recorded = recorded_motion(time_s, motion)
    np.testing.assert_allclose(recorded.pull_between(0.0, 0.4), down[0], atol=1e-9)
    np.testing.assert_allclose(recorded.pull_between(0.5, 0.99), down[0] - [1, 0, 0], atol=1e-9)
    np.testing.assert_allclose(recorded.pull_between(1.6, 1.9), down[0], atol=1e-6)
    nothing = recorded_motion(time_s, np.full_like(motion, np.nan))
    assert np.isnan(nothing.pull_between(0.0, 2.0)).all()


def test_a_recording_without_labels_gives_its_motion(tmp_path):
    time_s, motion, _ = turned((0.0, 0.0, 0.1), 1.0, 20.0)
    names = [f"acceleration_{a}_m_s2" for a in "xyz"] + [f"rate_{a}_rad_s" for a in "xyz"]
    rows = [",".join(["time_s", "F1-X1", *names])]
    rows += [",".join(map(str, [t, 5, *m])) for t, m in zip(time_s, motion, strict=True)]
    path = tmp_path / "grasp.csv"
    path.write_text("\n".join(rows) + "\n")
    recorded = read_motion(path)
    np.testing.assert_allclose(recorded.down[-1], (0, 0, -1), atol=1e-6)
    path.write_text("time_s,F1-X1\n0,1\n0.1,2\n")
    assert read_motion(path) is None
