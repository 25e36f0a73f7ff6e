"""The Pico's program, run by the real MicroPython against sensors that obey their data sheets."""

import numpy as np
import pytest

from design.spec.object import ObjectSpec
from design.wiring.dealing import EXPANDED, MIXED, MULTIPLEXED, STARTED
from estimator.recordings.boards.lines import Frame, Status
from tests.support.avr.board import celsius, field_mt, motion
from tests.support.pico.board import built, messages, needs_micropython

pytestmark = needs_micropython

MLX = {"part": "MLX90393", "range_mt": 49.2, "noise_counts": [5.0, 5.0, 5.0]}
TLE = {"part": "TLE493DW2B6A1", "noise_counts": [1.0, 1.0, 1.0]}


def object_of(**sensors):
    return ObjectSpec.model_validate({"name": "simulated", "sensors": sensors})


def expected(plan, counts_per_mt):
    fields = np.array([field_mt(k) for k in range(len(plan.chips))])
    return np.clip(np.round(fields * counts_per_mt), -32768, 32767)


def counts_of(found):
    frames = [message for message in found if isinstance(message, Frame)]
    return np.array([frame.counts for frame in frames]).reshape(len(frames), -1, 3), frames


@pytest.mark.parametrize(
    ("way", "sensors", "counts_per_mt"),
    [
        (STARTED, {}, 32768 / 40),
        (EXPANDED, {}, 32768 / 40),
        (MULTIPLEXED, {"part": "TMAG5273B1", "range_mt": 80.0}, 32768 / 80),
        (MIXED, MLX, 1e3 / 1.502),
        (MIXED, TLE, 15.4),
    ],
)
def test_every_sensor_gives_its_field(tmp_path, way, sensors, counts_per_mt):
    plan = built(object_of(**sensors), tmp_path, end_ms=1400, way=way)
    found, statistics = messages(tmp_path)
    counts, frames = counts_of(found)
    assert len(frames) >= 10
    tolerance = 1.0 if sensors is MLX else 0.0
    wanted = np.broadcast_to(expected(plan, counts_per_mt), counts.shape)
    np.testing.assert_allclose(counts, wanted, atol=tolerance)
    steps_ms = np.diff([frame.board_ms for frame in frames])
    assert 1e3 / steps_ms.mean() == pytest.approx(10.5, rel=0.02)
    assert (statistics.lost_frames, statistics.damaged_lines) == (0, 0)
    (status,) = [message for message in found if isinstance(message, Status)]
    degrees = 0.5 if sensors is TLE else 0.1  # steps of 0.96 degrees
    assert status.sensors_c == pytest.approx([celsius(k) for k in range(15)], abs=degrees)
    assert (status.bus_errors, status.start) == (0, "power")


def test_faults_cost_the_sensors_that_have_them_and_nothing_stays_lost(tmp_path):
    faults = [
        ("dead", 3, 0, 1e9),
        ("hang", 7, 400, 1e9),
        ("brownout", 5, 700, 1e9),
        ("low", 2, 300, 1e9),
    ]
    plan = built(object_of(), tmp_path, faults, end_ms=2900, way=STARTED)
    found, _ = messages(tmp_path)
    counts, _ = counts_of(found)
    silent = np.isnan(counts).any(axis=2)
    assert silent[:, 3].all()
    assert set(np.flatnonzero(silent.any(axis=0))) == {3, 5}
    assert not silent[-1, 5]
    right = np.where(silent[..., None], np.nan, expected(plan, 32768 / 40)[None])
    np.testing.assert_array_equal(counts, right)
    last = [message for message in found if isinstance(message, Status)][-1]
    assert (last.bus_recoveries, last.supply_errors) == (1, 1)


def test_a_sensor_that_never_lets_go_of_the_bus_is_cut_off(tmp_path):
    built(object_of(), tmp_path, [("stuck", 9, 250, 420)], end_ms=2600, way=STARTED)
    counts, _ = counts_of(messages(tmp_path)[0])
    silent = np.isnan(counts).any(axis=2)
    assert silent.any()
    assert not silent[-3:].any()


def test_sensors_that_an_expander_powers_are_lost_and_found_with_it(tmp_path):
    """The expander is absent at first; later a chip holds the bus, which only its reset can cut off."""
    faults = [("dead", -0x20, 0, 900), ("stuck", 9, 2500, 2650)]
    built(object_of(), tmp_path, faults, end_ms=5200, way=EXPANDED)
    counts, frames = counts_of(messages(tmp_path)[0])
    silent = np.isnan(counts).any(axis=2)
    ms = np.array([frame.board_ms for frame in frames])
    assert silent[ms < 900].all()
    assert not silent[(ms > 2200) & (ms < 2500)].any()
    assert silent[(ms > 2500) & (ms < 3000)].any()
    assert not silent[-3:].any()


def test_sensors_on_each_other_s_supply_are_read_in_each_other_s_place(tmp_path):
    """Wrong wiring: supplies of the first two are exchanged, which their fields tell."""
    plan = built(object_of(), tmp_path, end_ms=900, way=EXPANDED)
    module = tmp_path / "plan.py"
    text = module.read_text()
    swapped = text.replace("(32, 0)", "(32, 99)").replace("(32, 1)", "(32, 0)")
    module.write_text(swapped.replace("(32, 99)", "(32, 1)"))
    counts, _ = counts_of(messages(tmp_path)[0])
    right = expected(plan, 32768 / 40)
    np.testing.assert_array_equal(counts[-1][:2], right[[1, 0]])
    np.testing.assert_array_equal(counts[-1][2:], right[2:])


def test_a_program_that_waits_too_long_is_ended_by_its_watchdog(tmp_path):
    """The planted fault: a wait of 3 s before every frame."""
    built(object_of(), tmp_path, end_ms=9000, way=STARTED)
    program = tmp_path / "main.py"
    program.write_text(program.read_text().replace("    gc.collect()", "    time.sleep_ms(3000)"))
    _, frames = counts_of(messages(tmp_path)[0])
    assert len(frames) == 1


@pytest.mark.parametrize("imu", ["LSM6DS3", "ICM-42688"])
def test_an_imu_is_read_beside_the_chips(tmp_path, imu):
    spec = object_of().changed(imu=imu)
    plan = built(spec, tmp_path, [("dead", 15, 300, 700)], end_ms=2500, way=MULTIPLEXED)
    found, _ = messages(tmp_path)
    values = np.array([message.counts for message in found if isinstance(message, Frame)])
    silent = np.isnan(values[:, 45:]).all(axis=1)
    assert 2 < silent.sum() < 20
    assert not silent[-1]
    wanted = [motion()] * int((~silent).sum())
    np.testing.assert_allclose(values[~silent, 45:], wanted, atol=6e-3)
    wanted = expected(plan, 32768 / 40).reshape(1, -1).repeat(len(values), axis=0)
    np.testing.assert_array_equal(values[:, :45], wanted)
