"""An Arduino Mega in simavr: firmware built by avr-gcc, with simulated sensors, on a serial port."""

import shutil
import subprocess
import threading
import time
from contextlib import contextmanager
from pathlib import Path

import numpy as np
import pytest
from serial import Serial

from design.catalogue.bus_parts import MEGA2560
from design.wiring.bus_plan import choose_plan
from estimator.recordings.boards.lines import LineDecoder
from instobj.bench.firmware.mega2560_plan import port_of
from instobj.bench.firmware.project import project_files, write_project
from tests.support.shared import only_one

_SOURCE = Path(__file__).with_name("rig.c")
_SIMAVR = Path("/usr/include/simavr/sim_avr.h")
needs_simulator = pytest.mark.skipif(
    not (
        shutil.which("avr-gcc")
        and shutil.which("gcc")
        and shutil.which("make")
        and _SIMAVR.exists()
    ),
    reason="needs the Debian packages gcc, make, gcc-avr, avr-libc and libsimavr-dev",
)


def field_mt(number):
    """Field (mT) of the simulated sensor of that number, from 0."""
    return (number + 1.0, -number - 1.5, 0.5 * number)


def family(part):
    """Letter of a part in the simulators: T(MAG5273), M(LX90393), E for the TLE493D."""
    return "E" if part.startswith("TLE") else part[0]


def celsius(number):
    return 20.0 + number


IMU_G, IMU_DEG_S = (0.5, -0.75, 0.25), 30.0
"""Acceleration (g) of the simulated IMU, and the rate about x; about y it is -1, about z 2 times that."""


def motion():
    """Cells of the simulated IMU in a frame: m/s² and rad/s."""
    scale = np.radians(IMU_DEG_S)
    return [*(9.80665 * np.array(IMU_G)), scale, -scale, 2 * scale]


def built(spec, folder, **choice):
    """Plan and ELF file of a specification's firmware."""
    plan, _ = choose_plan(spec, MEGA2560, **choice)
    write_project(project_files(spec, plan), folder)
    subprocess.run(["make", "-s", "-C", folder], check=True)
    return plan, folder / "firmware.elf"


def world(plan, faults=(), fields=None, end_ms=2000, load=(), sps=80):
    """What the simulator is told: sensors as the plan wires them, faults (kind, sensor, from, until),
    and the load over time (ms, mV/V of an HX711's bridge or mV of a force sensor)."""
    lines = []
    for number, chip in enumerate(plan.chips):
        port, bit = ("-", 0) if chip.supply is None else port_of(chip.supply)
        route = (chip.multiplexer or 0, 0 if chip.channel is None else 1 << chip.channel)
        field = (fields or {}).get(number, field_mt(number))
        lines.append(
            f"chip {family(chip.part)} {chip.factory:x} {route[0]:x} {route[1]:x} {port} {bit} "
            f"{field[0]} {field[1]} {field[2]} {celsius(number)}"
        )
    if plan.imu is not None:
        values = " ".join(map(str, (*IMU_G, IMU_DEG_S)))
        lines.append(f"chip {plan.imu.name[0]} {plan.imu.address:x} 0 0 - 0 {values}")
    lines += [
        f"mux {address:x} {' '.join(map(str, port_of(plan.reset)))}"
        for _, address in plan.multiplexers
    ]
    lines += _load_cell(plan, sps)
    lines += [f"load {ms} {value}" for ms, value in load]
    lines += [f"fault {kind} {sensor} {first} {last}" for kind, sensor, first, last in faults]
    return "\n".join([*lines, f"end {end_ms}", ""])


def _load_cell(plan, sps):
    if plan.load is None:
        return []
    if plan.load.kind == "analog":
        return [f"voltage {plan.load.pins[0][1:]}"]
    pins = " ".join(f"{port} {bit}" for port, bit in map(port_of, plan.load.pins))
    return [f"hx711 {pins} {sps}"]


def bridge_mv_per_v(force_n, capacity_n=49.03, output_mv_per_v=1.0):
    """Output of the specification's bridge."""
    return force_n / capacity_n * output_mv_per_v


@contextmanager
def running(elf, text):
    """Name of the simulated board's serial port, and an event that is set when its time is over.

    It starts when it is asked for its channels.
    """
    world_file = elf.with_name("world.txt")
    world_file.write_text(text)
    process = subprocess.Popen(
        [_rig(), elf, world_file], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    )
    try:
        port = next(line.strip() for line in process.stdout if line.startswith("/dev/"))
        over = threading.Event()
        threading.Thread(
            target=lambda: (process.stdout.readline(), over.set()), daemon=True
        ).start()
        yield port, over
    finally:
        process.kill()
        process.wait()


def _rig():
    """The simulator, compiled once for all tests."""
    with only_one("avr_rig") as rig:
        if not rig.exists():
            command = ["gcc", "-O2", "-o", rig, _SOURCE, "-lsimavr", "-lutil", "-lm"]
            subprocess.run(command, check=True)
        return rig


def messages(elf, text):
    """All that the board says until its time is over, and what its line lost."""
    decoder, found = LineDecoder(), []
    with running(elf, text) as (port, over), Serial(port, timeout=0.05) as link:
        link.write(b"?")
        last = time.monotonic() + 200
        while not over.is_set() and time.monotonic() < last:
            found += decoder.feed(link.read(4096))
        found += decoder.feed(link.read(65536))
    return found, decoder.statistics


def of(kind, found):
    """The messages of one kind."""
    return [message for message in found if isinstance(message, kind)]
