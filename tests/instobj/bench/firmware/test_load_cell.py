"""Load cells read by the Mega's firmware in simavr: an HX711 and a voltage, and what is wrong with them."""

import numpy as np
import pytest

from design.spec.object import ObjectSpec
from estimator.recordings.boards.lines import Frame, Load, Status
from estimator.recordings.formats.files import read_table
from instobj.bench.collect.command import collect
from instobj.bench.collect.options import CollectOptions
from tests.support.avr.board import (
    bridge_mv_per_v,
    built,
    messages,
    needs_simulator,
    of,
    running,
    world,
)

pytestmark = needs_simulator

COUNT_N = 49.03 / (1e-3 * 128 * 2**24)
STEP_N = 24.5 * 5 / 1024


def object_of(kind, **cell):
    return ObjectSpec.model_validate({"name": "pressed", "load_cell": {"kind": kind, **cell}})


@pytest.fixture(scope="module")
def bridge(tmp_path_factory):
    """The paper's cube with an HX711 on the paper's board."""
    return built(object_of("hx711"), tmp_path_factory.mktemp("bridge"))


@pytest.fixture(scope="module")
def voltage(tmp_path_factory):
    return built(object_of("analog"), tmp_path_factory.mktemp("voltage"))


def ramp(first_n, last_n, until_ms=2000):
    return [(0, bridge_mv_per_v(first_n)), (until_ms, bridge_mv_per_v(last_n))]


def loads_of(found):
    loads = of(Load, found)
    assert all((load.cell, load.face) == (1, None) for load in loads)
    return np.array([load.board_ms for load in loads]), np.array([load.force_n for load in loads])


def test_every_conversion_of_the_hx711_comes_right_to_the_count_when_it_was_read(bridge):
    """A load from −5 to 15 N: the two's complement, the scale, and the time of every reading."""
    plan, elf = bridge
    found, statistics = messages(elf, world(plan, load=ramp(-5, 15)))
    ms, force_n = loads_of(found)
    assert len(ms) == pytest.approx(80 * (2.0 - 0.05), abs=12)
    assert set(np.diff(ms)) <= {12, 13}
    early_n = (ms - 1.0) * 0.01 - 5
    assert (force_n < early_n + 0.0100 + COUNT_N + 5e-5).all()
    assert (force_n > early_n - COUNT_N - 5e-5).all()
    assert (statistics.damaged_lines, statistics.lost_frames) == (0, 0)


def test_a_load_that_stands_still_is_right_to_a_tenth_of_a_millinewton(bridge):
    plan, elf = bridge
    for force_n in (-7.1234, 0.0, 12.3456):
        loads = [(0, bridge_mv_per_v(force_n))]
        _, told_n = loads_of(messages(elf, world(plan, load=loads, end_ms=500))[0])
        assert len(set(told_n)) == 1
        assert told_n[0] == pytest.approx(force_n, abs=0.6e-4 + COUNT_N / 2)


@pytest.mark.parametrize(("force_n", "sign"), [(500.0, 1), (-500.0, -1)])
def test_beyond_its_range_the_hx711_says_full_scale(bridge, force_n, sign):
    """±2²³ counts: 191.5 N of a cell for 49 N, more than any limit."""
    plan, elf = bridge
    loads = [(0, bridge_mv_per_v(force_n))]
    _, told_n = loads_of(messages(elf, world(plan, load=loads, end_ms=500))[0])
    assert told_n == pytest.approx(sign * 2**23 * COUNT_N, abs=1e-3)


def test_a_chip_that_comes_late_or_leaves_is_read_while_it_is_there(bridge):
    plan, elf = bridge
    faults = [("gone", -2, 0, 400), ("shorted", -2, 900, 1200)]
    found, _ = messages(elf, world(plan, faults, load=ramp(3, 3), end_ms=1600))
    ms, force_n = loads_of(found)
    assert len(of(Frame, found)) > 12, "frames go on"
    assert ms.min() == pytest.approx(400, abs=20)
    assert not ((ms > 915) & (ms < 1200)).any()
    assert ms.max() > 1500
    assert force_n == pytest.approx(3.0, abs=1e-3)


def test_an_hx711_left_at_10_readings_a_second_is_read_at_that(bridge):
    plan, elf = bridge
    ms, _ = loads_of(messages(elf, world(plan, load=ramp(3, 3), sps=10))[0])
    assert set(np.diff(ms)) <= {99, 100, 101}
    assert ms[0] >= 400


def test_a_voltage_is_read_as_the_mean_of_many_conversions(voltage):
    """2.5 V are no load, 24.5 N a volt; a ramp of 0.2 V/s; the supply is measured in between."""
    plan, elf = voltage
    found, statistics = messages(elf, world(plan, load=[(0, 2500), (2000, 2900)]))
    ms, force_n = loads_of(found)
    assert np.diff(ms).mean() == pytest.approx(27, abs=3)
    assert force_n == pytest.approx(24.5 * 2e-4 * ms, abs=STEP_N)
    assert of(Status, found)[-1].supply_mv == pytest.approx(5000, rel=0.01)
    assert (statistics.damaged_lines, statistics.lost_frames) == (0, 0)


def test_another_input_and_other_figures_of_a_force_sensor(tmp_path):
    """The Vernier's ±10 N range on A5."""
    cell = {"pins": ["A5"], "scale_n": -4.9}
    plan, elf = built(object_of("analog", **cell), tmp_path)
    _, told_n = loads_of(messages(elf, world(plan, load=[(0, 1000)], end_ms=500))[0])
    assert told_n == pytest.approx(1.5 * 4.9, abs=4.9 * 5 / 1024)


def test_the_planned_rate_is_kept_with_a_load_cell(tmp_path):
    """At 95 % of the fastest rate that the plan promises no frame is late."""
    whole = {"name": "fast", "sensors": {"averaging": 4}, "load_cell": {"kind": "hx711"}}
    promised, _ = built(ObjectSpec.model_validate(whole), tmp_path / "slow")
    whole["sensors"]["frame_rate_hz"] = round(0.95 * promised.time.fastest_hz, 1)
    plan, elf = built(ObjectSpec.model_validate(whole), tmp_path / "fast")
    assert plan.baud == promised.baud
    found, _ = messages(elf, world(plan, load=ramp(0, 5)))
    times_ms = [frame.board_ms for frame in of(Frame, found)]
    rate_hz = whole["sensors"]["frame_rate_hz"]
    assert 1e3 / np.diff(times_ms).mean() == pytest.approx(rate_hz, rel=0.01)
    assert np.diff(loads_of(found)[0]).max() < 60


def test_collect_labels_frames_with_the_force_at_their_time(bridge, tmp_path):
    """A load that grows by 2 N a second, without --load-port: 0.2 N a frame, told to 0.02 N."""
    plan, elf = bridge
    text = world(plan, load=ramp(0, 20, 10000), end_ms=1e9)
    with running(elf, text) as (port, _):
        options = CollectOptions(
            tmp_path / "one", port, places=("3:0,0",), zero_frames=4, frames=20
        )
        result = collect(options)
    table = read_table(tmp_path / "one.csv")
    force_n = np.asarray(table.force_n)[:, 0]
    lag = force_n - np.polyval(np.polyfit(np.arange(20), force_n, 1), np.arange(20))
    assert np.abs(lag).max() < 0.02
    assert np.polyfit(np.arange(20), force_n, 1)[0] == pytest.approx(2 / 10.5, rel=0.02)
    assert (result["lost_frames"], result["damaged_lines"]) == (0, 0)
