"""Load cells read by the Pico's program in MicroPython: an HX711, a voltage, and their faults."""

import numpy as np
import pytest

from design.spec.object import ObjectSpec
from estimator.recordings.boards.lines import Frame, Load
from tests.support.avr.board import bridge_mv_per_v
from tests.support.pico.board import built, messages, needs_micropython

pytestmark = needs_micropython

COUNT_N = 49.03 / (1e-3 * 128 * 2**24)


def object_of(kind, **cell):
    return ObjectSpec.model_validate({"name": "pressed", "load_cell": {"kind": kind, **cell}})


def run(spec, folder, **world):
    """Plan, clock (ms) and force (N) of every line `L`, clocks of the frames, and what was lost."""
    plan = built(spec, folder, **world)
    found, statistics = messages(folder)
    loads = [message for message in found if isinstance(message, Load)]
    assert all((load.cell, load.face) == (1, None) for load in loads)
    frames = np.array([message.board_ms for message in found if isinstance(message, Frame)])
    ms = np.array([load.board_ms for load in loads])
    return plan, ms, np.array([load.force_n for load in loads]), frames, statistics


def test_conversions_of_the_hx711_come_right_to_the_count_when_they_were_read(tmp_path):
    """A load from −5 to 15 N in 2 s; the program passes by every few milliseconds."""
    load = [(0, bridge_mv_per_v(-5.0)), (2000, bridge_mv_per_v(15.0))]
    _, ms, force_n, frames, statistics = run(object_of("hx711"), tmp_path, load=load)
    assert len(ms) > 130
    late_n = 0.01 * ms - 5 - force_n
    assert late_n.min() > -0.02
    assert late_n.max() < 0.01 * 4 + 0.02
    assert 1e3 / np.diff(frames).mean() == pytest.approx(10.5, rel=0.02)
    assert (statistics.lost_frames, statistics.damaged_lines) == (0, 0)


@pytest.mark.parametrize("force_n", [12.3456, -500.0])
def test_a_load_that_stands_still_is_right_and_full_scale_is_kept(tmp_path, force_n):
    load = [(0, bridge_mv_per_v(force_n))]
    _, _, told_n, _, _ = run(object_of("hx711"), tmp_path, load=load, end_ms=500)
    limit_n = 2**23 * COUNT_N
    assert len(set(told_n)) == 1
    assert told_n[0] == pytest.approx(np.clip(force_n, -limit_n, limit_n), abs=2e-4)


def test_without_a_chip_no_force_is_made_up_and_frames_go_on(tmp_path):
    faults = [("gone", -2, 0, 600), ("shorted", -2, 900, 1200)]
    load = [(0, bridge_mv_per_v(3.0))]
    _, ms, force_n, frames, _ = run(object_of("hx711"), tmp_path, faults=faults, load=load)
    assert ms.min() >= 600
    assert not ((ms > 900) & (ms < 1200)).any()
    assert ms.max() > 1900
    assert force_n == pytest.approx(3.0, abs=1e-3)
    assert np.diff(frames) == pytest.approx(1000 / 10.5, abs=4)


def test_a_voltage_is_read_through_the_divider(tmp_path):
    """10 N are 2.5 V + 10 / 24.5 V at the sensor, 0.6 of that at the pin."""
    load = [(0, 600 * (2.5 + 10 / 24.5))]
    plan, ms, force_n, frames, _ = run(object_of("analog"), tmp_path, load=load)
    assert plan.load.pins == ("GP28",)
    assert force_n == pytest.approx(10.0, abs=24.5 * 3.3 / 4096 / 0.6)
    assert np.diff(ms).mean() == pytest.approx(27, abs=3)
    assert np.diff(frames) == pytest.approx(1000 / 10.5, abs=4)
