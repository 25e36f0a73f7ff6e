"""The Mega's firmware, built by avr-gcc and run by simavr against sensors that obey their data sheets."""

import numpy as np
import pytest

from design.spec.object import ObjectSpec
from design.wiring.dealing import MIXED, MULTIPLEXED, STARTED
from estimator.recordings.boards.lines import Frame, Header, Status
from estimator.recordings.formats.files import read_table
from instobj.bench.collect.command import collect
from instobj.bench.collect.options import CollectOptions
from tests.support.avr.board import (
    built,
    celsius,
    field_mt,
    messages,
    motion,
    needs_simulator,
    of,
    running,
    world,
)

pytestmark = needs_simulator

MLX = {"part": "MLX90393", "range_mt": 49.2, "noise_counts": [5.0, 5.0, 5.0]}
TLE = {"part": "TLE493DW2B6A1", "noise_counts": [1.0, 1.0, 1.0]}
COUNTS_PER_MT = 32768 / 40


def object_of(**sensors):
    return ObjectSpec.model_validate({"name": "simulated", "sensors": sensors})


def expected(plan, counts_per_mt=COUNTS_PER_MT):
    fields = np.array([field_mt(k) for k in range(len(plan.chips))])
    return np.clip(np.round(fields * counts_per_mt), -32768, 32767)


def rows(found):
    frames = of(Frame, found)
    return np.array([frame.board_ms for frame in frames]), np.array(
        [frame.counts for frame in frames]
    ).reshape(len(frames), -1, 3)


@pytest.fixture(scope="module")
def paper(tmp_path_factory):
    """The paper's cube on the paper's board."""
    return built(object_of(), tmp_path_factory.mktemp("paper"), way=STARTED)


def test_collect_gets_the_paper_cubes_frames_right_to_the_count(paper, tmp_path):
    """15 chips of one factory address, 45 channels, one of them beyond its range."""
    plan, elf = paper
    fields = {4: (45.0, -45.0, 1.0)}
    with running(elf, world(plan, fields=fields, end_ms=1e9)) as (port, _):
        result = collect(CollectOptions(tmp_path / "first", port, zero_frames=16, frames=16))
    counts = read_table(tmp_path / "first.csv").counts
    wanted = expected(plan)
    wanted[4] = (32767, -32768, round(COUNTS_PER_MT))
    np.testing.assert_array_equal(counts, np.broadcast_to(wanted.reshape(5, 3, 3), counts.shape))
    assert result["rate_hz"] == pytest.approx(10.5, abs=0.3)
    assert (result["lost_frames"], result["damaged_lines"], result["restarts"]) == (0, 0, 0)
    board = result["board"]
    assert board["sensors_c"] == pytest.approx([celsius(k) for k in range(15)], abs=0.1)
    assert board["supply_mv"] == pytest.approx(5000, rel=0.01)
    assert (board["bus_errors"], board["start"]) == (0, "power")


@pytest.mark.parametrize(
    ("way", "sensors", "counts_per_mt"),
    [
        (MULTIPLEXED, {"range_mt": 80.0, "averaging": 32}, 32768 / 80),
        (MIXED, {"axes": ["X", "Z"]}, COUNTS_PER_MT),
        (MIXED, MLX, 1e3 / 1.502),
        (MIXED, TLE, 15.4),
    ],
)
def test_other_plans_give_every_sensor_its_field(tmp_path, way, sensors, counts_per_mt):
    spec = object_of(**sensors)
    plan, elf = built(spec, tmp_path, way=way)
    found, statistics = messages(elf, world(plan, end_ms=400))
    axes = ["XYZ".index(axis) for axis in spec.sensors.axes]
    assert of(Header, found)[0].channels[:2] == ("F1-X1", "F1-Y1" if len(axes) == 3 else "F1-Z1")
    wanted = expected(plan, counts_per_mt)[:, axes].ravel()
    frames = of(Frame, found)
    assert len(frames) >= 2
    for frame in frames:
        np.testing.assert_allclose(frame.counts, wanted, atol=1.0 if sensors is MLX else 0.0)
    assert (statistics.damaged_lines, statistics.lost_frames) == (0, 0)


def test_faults_cost_the_sensors_that_have_them_and_nothing_stays_lost(paper):
    """A sensor that never answers, one that holds the bus, one that loses its address, low supply."""
    plan, elf = paper
    faults = [
        ("dead", 3, 0, 1e9),
        ("hang", 7, 400, 1e9),
        ("brownout", 5, 700, 1e9),
        ("low", 2, 300, 1e9),
    ]
    found, statistics = messages(elf, world(plan, faults, end_ms=2900))
    times_ms, counts = rows(found)
    silent = np.isnan(counts).any(axis=2)
    assert silent[:, 3].all()
    assert set(np.flatnonzero(silent.any(axis=0))) == {3, 5}
    gone_ms = times_ms[silent[:, 5]]
    assert gone_ms[0] >= 700
    assert gone_ms[-1] - gone_ms[0] < 1100
    assert not silent[-1, 5]
    right = np.where(silent[..., None], np.nan, expected(plan)[None])
    np.testing.assert_array_equal(counts, right)
    last = of(Status, found)[-1]
    assert (last.bus_recoveries, last.supply_errors) == (1, 1)
    assert last.bus_errors >= 2
    assert statistics.damaged_lines == 0


def test_a_sensor_that_never_lets_go_of_the_bus_loses_its_power(paper):
    plan, elf = paper
    found, _ = messages(elf, world(plan, [("stuck", 9, 250, 420)], end_ms=2600))
    times_ms, counts = rows(found)
    silent = np.isnan(counts).any(axis=2)
    assert silent[(times_ms > 260) & (times_ms < 1000)].any()
    assert not silent[-3:].any()
    assert of(Status, found)[-1].bus_recoveries >= 1


def test_behind_a_multiplexer_a_stuck_sensor_is_lost_alone(tmp_path):
    plan, elf = built(object_of(), tmp_path, way=MULTIPLEXED)
    found, _ = messages(elf, world(plan, [("stuck", 4, 250, 1e9)], end_ms=900))
    _, counts = rows(found)
    silent = np.isnan(counts).any(axis=2)
    assert set(np.flatnonzero(silent.any(axis=0))) == {4}
    assert silent[-1, 4]


def test_the_watchdog_restarts_a_board_whose_clock_stands_still(paper):
    plan, elf = paper
    found, statistics = messages(elf, world(plan, [("freeze", -1, 300, 1e9)], end_ms=3900))
    assert [status.start for status in of(Status, found)][-1] == "watchdog"
    sequences = [frame.sequence for frame in of(Frame, found)]
    assert sequences.count(0) == 2
    assert statistics.damaged_lines <= 1


def test_the_planned_rate_is_kept_by_the_simulated_board(tmp_path):
    """At 95 % of the fastest rate that the plan promises no frame is late."""
    promised, _ = built(object_of(averaging=4), tmp_path / "slow", way=MIXED)
    rate_hz = round(0.95 * promised.time.fastest_hz, 1)
    plan, elf = built(object_of(averaging=4, frame_rate_hz=rate_hz), tmp_path / "fast", way=MIXED)
    assert plan.baud == promised.baud
    times_ms, _ = rows(messages(elf, world(plan, end_ms=1000))[0])
    assert 1e3 / np.diff(times_ms).mean() == pytest.approx(rate_hz, rel=0.01)


def test_a_tle493d_that_lost_its_settings_is_started_anew(tmp_path):
    """It answers after a brownout, at its own address, with interrupts and range of its power-up."""
    plan, elf = built(object_of(**TLE), tmp_path, way=MIXED)
    found, statistics = messages(elf, world(plan, [("brownout", 5, 400, 1e9)], end_ms=1900))
    times_ms, counts = rows(found)
    silent = np.isnan(counts).any(axis=2)
    assert set(np.flatnonzero(silent.any(axis=0))) == {5}
    assert 400 <= times_ms[silent[:, 5]][0] < 600
    assert not silent[-1, 5]
    wanted = np.where(silent[..., None], np.nan, expected(plan, 15.4)[None])
    np.testing.assert_array_equal(counts, wanted)
    assert statistics.damaged_lines == 0
    degrees = np.delete(of(Status, found)[-1].sensors_c, 5) - np.delete(20.0 + np.arange(15), 5)
    assert abs(degrees).max() < 0.5


@pytest.mark.parametrize("imu", ["LSM6DS3", "ICM-42688"])
def test_an_imu_is_read_beside_the_chips_and_lands_in_the_recording(tmp_path, imu):
    """It is silent for a while: its cells are empty, those of the chips go on, and it is set up anew."""
    plan, elf = built(object_of().changed(imu=imu), tmp_path / "firmware", way=STARTED)
    faults = [("dead", len(plan.chips), 300, 700)]
    with running(elf, world(plan, faults, end_ms=1e9)) as (port, _):
        collect(CollectOptions(tmp_path / "first", port, zero_frames=25, frames=25))
    table = read_table(tmp_path / "first.nc")
    silent = np.isnan(table.motion).all(axis=1)
    assert 2 < silent.sum() < 20
    assert not silent[0]
    assert not silent[-1]
    np.testing.assert_allclose(table.motion[~silent], [motion()] * (~silent).sum(), atol=6e-3)
    assert np.isfinite(table.counts[:, :5, :3]).all()
