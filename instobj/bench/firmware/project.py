"""A firmware project as files: sources of the board, settings of the object, and what to do with them."""

from __future__ import annotations

from dataclasses import astuple
from pathlib import Path

from design.build.order_list import ORDER_COLUMNS, order_list, order_row
from design.catalogue.bus_parts import MEGA2560, MLX90393, TLE493D, TMAG5273
from design.files import atomic_path
from design.spec.load_cell import SUPPLY_V
from design.spec.object import ObjectSpec
from design.tables import table_text
from design.wiring.bus_plan import BusPlan
from design.wiring.dealing import ChipOnBus
from design.wiring.wires import wires_of
from instobj.bench.firmware.drawing import wiring_svg
from instobj.bench.firmware.mega2560_plan import plan_header
from instobj.bench.firmware.micropython_plan import plan_module
from instobj.bench.firmware.settings import family_of, supply_text
from instobj.store.readers import ORDERS

_SOURCES = Path(__file__).parent
_DRIVERS = {chip.driver for chip in (TMAG5273, MLX90393, TLE493D)}


def project_files(spec: ObjectSpec, plan: BusPlan) -> dict[str, str]:
    """Texts of the files by their names.

    Raises
    ------
    InputError
        Settings that the chip cannot take.
    """
    driver = family_of(plan).driver
    folder = "mega2560" if plan.board is MEGA2560 else "micropython"
    files = {
        path.name: path.read_text(encoding="utf-8")
        for path in sorted((_SOURCES / folder).iterdir())
        if path.is_file() and (path.stem == driver or path.stem not in _DRIVERS)
    }
    if plan.board is MEGA2560:
        files["plan.h"] = plan_header(spec, plan)
    else:
        files["chip.py"] = files.pop(f"{driver}.py")
        files["plan.py"] = plan_module(spec, plan)
        if plan.board.battery_pin:
            files["link.py"] = files["radio.py"]
        else:
            files["link.py"] = files.pop("usb.py")
            del files["radio.py"], files["bridge.py"]
    return {**files, "README.md": _readme(spec, plan), **_bench_files(spec, plan)}


def _bench_files(spec: ObjectSpec, plan: BusPlan) -> dict[str, str]:
    """Return what lies next to the soldering iron: drawing, wires in order, parts to buy."""
    title = f"Wiring of {spec.name} on the {plan.board.title}, seen from the pads"
    wires = [astuple(wire) for wire in wires_of(plan)]
    return {
        "wiring.svg": wiring_svg(plan, title),
        "wiring.csv": table_text(("wire", "from", "to", "signal", "colour", "length_mm"), wires),
        ORDERS.name: table_text(ORDER_COLUMNS, map(order_row, order_list(spec, plan))),
    }


def _readme(spec: ObjectSpec, plan: BusPlan) -> str:
    mega = plan.board is MEGA2560
    return _README.format(
        name=spec.name,
        board=plan.board.title,
        way=plan.way,
        count=len(plan.chips),
        rate=spec.sensors.frame_rate_hz,
        baud=plan.baud,
        pullup=plan.pullup_kohm,
        install=_INSTALL_MEGA if mega else _install_micropython(plan),
        plan="plan.h" if mega else "plan.py",
        rows="\n".join(_row(chip) for chip in plan.chips),
        load=_load_text(spec, plan),
        imu=_imu_text(plan),
    )


def _load_text(spec: ObjectSpec, plan: BusPlan) -> str:
    """Return what the README says of the load cell."""
    cell, load = spec.load_cell, plan.load
    if load is None:
        return ""
    if load.kind == "hx711":
        scale = (
            f"{cell.newtons_per_unit:g} N per mV/V at gain 128. Set the board's RATE to "
            f"{load.lines_hz:g} readings per second."
        )
    else:
        scale = f"{cell.newtons_per_unit:g} N/V, {SUPPLY_V / 2:g} V without load."
    lines = "Its forces go out as lines `L`; check the scale with a weight."
    return f"\n- Load cell: {load.title}; {scale} {lines}"


def _imu_text(plan: BusPlan) -> str:
    """Return what the README says of the IMU."""
    if plan.imu is None:
        return ""
    return (
        f"\n- IMU: {plan.imu.name} at 0x{plan.imu.address:02X}, x, y, z along the object's. "
        "Each frame ends with its acceleration (m/s²) and angular rate (rad/s)."
    )


def _row(chip: ChipOnBus) -> str:
    channel = "" if chip.channel is None else f"0x{chip.multiplexer:02X} channel {chip.channel}"
    cells = (chip.label, chip.part, channel, f"0x{chip.address:02X}", supply_text(chip))
    return f"| {' | '.join(cells)} |"


def _install_micropython(plan: BusPlan) -> str:
    program = "main.py plan.py chip.py bus.py expander.py sensors.py imu.py load_cell.py link.py"
    bridge = _INSTALL_BRIDGE if plan.board.battery_pin else ""
    return _INSTALL_MICROPYTHON.format(files=program) + bridge


_INSTALL_MEGA = """\
    sudo apt install gcc-avr avr-libc binutils-avr make avrdude
    make
    make flash PORT=/dev/ttyACM0"""
_INSTALL_MICROPYTHON = """\
    # MicroPython 1.25 or newer on the board: micropython.org/download
    pip install mpremote
    mpremote cp {files} : + reset"""
_INSTALL_BRIDGE = """
    # a second board of the same kind, which stays on USB
    mpremote cp radio.py usb.py : + cp bridge.py :main.py + reset"""
_README = """\
# Firmware of {name} for the {board}
{count} sensors by {way}, {rate:g} frames per second, {baud} baud; pull-ups {pullup:g} kΩ on every bus line.
Written by `instobj bench firmware`; `{plan}` holds all that belongs to this object.

{install}
    instobj bench collect FIRST --port /dev/ttyACM0@{baud}

`wiring.svg` is the drawing; `wiring.csv` has every wire with colour and length in the order of soldering,
`orders.csv` every part to buy.

| sensor | part | multiplexer | address | supply |
|---|---|---|---|---|
{rows}

- A sensor that does not answer twice leaves its cells empty; it is started anew every second.
- A bus that hangs for 2.5 ms is clocked free and multiplexers are reset; if the data line stays low,
  sensors on supply pins lose their power and are started anew.
- The watchdog restarts the board after 2 s. Once a second a line `S` tells supply, errors, why the board
  started, and the temperature of every sensor (`instobj docs recordings`).{load}{imu}
"""


def write_project(files: dict[str, str], folder: Path) -> list[Path]:
    """Write a project; drivers of an earlier one that it does not have are removed.

    Raises
    ------
    StoreError
        The folder cannot be written.
    """
    folder.mkdir(parents=True, exist_ok=True)
    for name in {f"{driver}.c" for driver in _DRIVERS} - files.keys():
        (folder / name).unlink(missing_ok=True)
    for name, text in files.items():
        with atomic_path(folder / name) as path:
            path.write_text(text, encoding="utf-8")
    return [folder / name for name in files]
