"""Loggers that are faster than the sensors: what repeats by a clock, and what by chance."""

from dataclasses import replace

import numpy as np
import pytest

from estimator.recordings.checks.repeats import repeat_faults, repeated_readings
from estimator.recordings.formats.netcdf import write_generic_netcdf
from estimator.recordings.reading import read_recording

SLOW = 3
NOISE_COUNTS = 20.0


def presses(rows, noise, sensors=2, seed=0):
    """Counts of face 3: presses of 60 rows with rests between, and the sensors' own noise."""
    rng = np.random.default_rng(seed)
    force = 9.0 * np.clip(np.sin(2 * np.pi * np.arange(rows) / 120), 0, None)
    counts = np.full((rows, 5, sensors, 3), np.nan)
    gains = rng.uniform(20, 60, (sensors, 3))
    counts[:, 2] = force[:, None, None] * gains + noise * rng.standard_normal((rows, sensors, 3))
    return np.round(counts)


def held(counts, ratio, sensor_by_sensor=False, jitter=0.0):
    """The same logged `ratio` times as fast; each sensor at its own instants, if asked for."""
    rng = np.random.default_rng(1)
    rows = int(len(counts) * ratio) - 2 * int(ratio + 1)
    fast = np.empty((rows, *counts.shape[1:]))
    when = np.arange(rows) + jitter * rng.uniform(-1, 1, rows)
    for sensor in range(counts.shape[2]):
        late = 0.37 * sensor if sensor_by_sensor else 0.0
        row = np.maximum.accumulate(np.maximum((when / ratio + late).astype(int), 0))
        fast[:, :, sensor] = counts[row, :, sensor]
    return fast


@pytest.mark.parametrize("noise", [0.0, 0.2, 0.5, 1.0, NOISE_COUNTS])
def test_chance_and_rests_without_noise_are_no_clock(noise):
    found = repeated_readings(presses(1500, noise))
    assert not found.stale.any()
    assert not found.rows.any()
    assert repeat_faults(found, 10.0) == []


@pytest.mark.parametrize(
    ("ratio", "jitter"), [(1.15, 0.0), (1.4, 0.3), (2.0, 0.0), (3.0, 0.5), (10.3, 0.0)]
)
@pytest.mark.parametrize("noise", [0.6, NOISE_COUNTS])
def test_sensors_that_convert_together_repeat_whole_rows(ratio, jitter, noise):
    found = repeated_readings(held(presses(1500, noise), ratio, jitter=jitter))
    assert 1 / (1 - found.rows.mean()) == pytest.approx(ratio, rel=0.05)
    assert found.stale[found.rows][:, 2].all()
    assert not found.stale[~found.rows].any()


def test_sensors_that_convert_one_by_one_are_told_one_by_one():
    found = repeated_readings(held(presses(900, NOISE_COUNTS, 3), 2.5, sensor_by_sensor=True))
    assert not found.rows.any()
    assert 1 / (1 - found.share[2]) == pytest.approx([2.5] * 3, rel=0.01)
    (fault,) = repeat_faults(found, 100.0)
    assert fault.where == "all 3 sensors"
    assert "kept, for the sensors convert at different times" in fault.action


def test_one_slow_sensor_among_others_is_named():
    counts = presses(900, NOISE_COUNTS, 3)
    counts[:, :, 1] = held(counts, 2.0)[: len(counts), :, 1]
    (fault,) = repeat_faults(repeated_readings(counts), 50.0)
    assert fault.where == "F3-S2"
    assert fault.detail.endswith("they convert 25 times a second, logged 50 times")


def test_a_recording_by_a_fast_logger_has_the_noise_of_its_sensors(table, tmp_path):
    """Three rows for each conversion: noise from all of them is √3 too small."""
    last = np.arange(len(table.counts)) // SLOW * SLOW
    write_generic_netcdf(replace(table, counts=table.counts[last]), tmp_path / "slow.nc")
    found = read_recording(tmp_path / "slow.nc")
    (fault,) = [fault for fault in found.report.faults if fault.kind == "slow sensors"]
    assert fault.where == "all 15 sensors"
    assert fault.detail.startswith("67 % of their readings repeat the one before exactly")
    assert "1.7 times too small" in fault.action
    assert "n/3 readings; repeated rows not used" in fault.action
    assert found.frames.noise_counts == pytest.approx(NOISE_COUNTS, rel=0.1)
    shown = str(found.report)
    assert "forces up to 18.5 N; noise at rest " in shown
    assert "counts, medians over 45 channels" in shown
    assert "6 presses of 2 contact cases on faces 3, 5" in shown
    used = np.flatnonzero(found.frames.valid)
    assert set(used % SLOW) == {0}
    assert len(used) > 0.8 * len(last) / SLOW
