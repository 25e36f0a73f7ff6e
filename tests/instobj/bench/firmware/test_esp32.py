"""The program of ESP32s in MicroPython: over USB as the Pico's, and by ESP-NOW through a bridge."""

import numpy as np
import pytest

from design.catalogue.bus_parts import BOARDS
from design.errors import InputError
from design.spec.object import ObjectSpec
from design.wiring.bus_plan import choose_plan
from estimator.recordings.boards.lines import Frame, Status
from tests.support.avr.board import field_mt
from tests.support.pico.board import bridged, built, messages, needs_micropython, packets_of

CUBE = ObjectSpec(name="cube")


def frames_of(found):
    return [message for message in found if isinstance(message, Frame)]


def require_right(frames, plan):
    fields = np.array([field_mt(k) for k in range(len(plan.chips))])
    expected = np.round(fields * 32768 / 40).ravel()
    np.testing.assert_array_equal([frame.counts for frame in frames], [expected] * len(frames))


@needs_micropython
def test_every_sensor_gives_its_field_over_usb(tmp_path):
    plan = built(CUBE, tmp_path, end_ms=1400, board=BOARDS["esp32s3"])
    found, statistics = messages(tmp_path)
    assert len(frames_of(found)) >= 10
    require_right(frames_of(found), plan)
    (status,) = [message for message in found if isinstance(message, Status)]
    assert (status.bus_errors, status.supply_mv) == (0, None)
    assert (statistics.lost_frames, statistics.damaged_lines) == (0, 0)


@needs_micropython
def test_frames_of_a_wireless_object_come_through_the_bridge_and_lost_packets_are_counted(tmp_path):
    """A second object in the room is not mixed in; stamps are those of the object."""
    plan = built(CUBE, tmp_path / "object", end_ms=1400, board=BOARDS["esp32c3-espnow"])
    messages(tmp_path / "object")
    packets = packets_of(tmp_path / "object")
    assert max(len(packet) for _, packet in packets) == 250
    other = bytes(range(6))
    mixed = [pair for mac, packet in packets for pair in ((mac, packet), (other, packet))]
    found, statistics = bridged(tmp_path / "object", tmp_path / "bridge", mixed)
    frames = frames_of(found)
    assert len(frames) >= 10
    require_right(frames, plan)
    assert np.diff([frame.board_ms for frame in frames]) == pytest.approx(1000 / 10.5, abs=4)
    (status,) = [message for message in found if isinstance(message, Status)]
    assert status.supply_mv == 3800
    assert (statistics.lost_frames, statistics.damaged_lines) == (0, 0)
    lost = [pair for k, pair in enumerate(packets) if k != 7]
    found, statistics = bridged(tmp_path / "object", tmp_path / "lossy", lost)
    require_right(frames_of(found), plan)
    assert statistics.damaged_lines + statistics.lost_frames == 1
    assert len(frames) - 2 <= len(frames_of(found)) < len(frames)


def test_an_analogue_load_cell_is_refused_where_no_pin_reads_it():
    spec = CUBE.changed(load_cell={"kind": "analog"})
    with pytest.raises(InputError, match=r"has no pin for it\. Take load_cell\.kind"):
        choose_plan(spec, BOARDS["esp32s3"])
