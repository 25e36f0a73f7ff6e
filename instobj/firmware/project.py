"""A firmware project as files: sources of the board, settings of the object, and what to do with them."""

from __future__ import annotations

from pathlib import Path

from design.catalogue.bus_parts import MEGA2560, TMAG5273
from design.files import atomic_path
from design.spec.object import ObjectSpec
from design.wiring.bus_plan import BusPlan
from design.wiring.dealing import ChipOnBus
from instobj.firmware.mega2560_plan import plan_header
from instobj.firmware.settings import family_of

_SOURCES = Path(__file__).parent
_DRIVERS = ("tmag5273.c", "mlx90393.c")


def project_files(spec: ObjectSpec, plan: BusPlan) -> dict[str, str]:
    """Texts of the files by their names.

    Raises
    ------
    InputError
        Settings that the chip cannot take.
    """
    if plan.board is not MEGA2560:
        return {}  # sources for other boards follow
    files = {
        path.name: path.read_text(encoding="utf-8")
        for path in sorted((_SOURCES / plan.board.name).iterdir())
        if path.is_file()
    }
    other = _DRIVERS[1] if family_of(plan) is TMAG5273 else _DRIVERS[0]
    files.pop(other, None)
    return {**files, "plan.h": plan_header(spec, plan), "README.md": _readme(spec, plan)}


def _readme(spec: ObjectSpec, plan: BusPlan) -> str:
    return _README.format(
        name=spec.name,
        board=plan.board.title,
        way=plan.way,
        count=len(plan.chips),
        rate=spec.sensors.frame_rate_hz,
        baud=plan.baud,
        pullup=plan.pullup_kohm,
        rows="\n".join(_row(chip) for chip in plan.chips),
    )


def _row(chip: ChipOnBus) -> str:
    channel = "" if chip.channel is None else f"0x{chip.multiplexer:02X} channel {chip.channel}"
    cells = (chip.label, chip.part, channel, f"0x{chip.address:02X}", chip.supply or "3.3 V")
    return f"| {' | '.join(cells)} |"


_README = """\
# Firmware of {name} for the {board}
{count} sensors by {way}, {rate:g} frames per second, {baud} baud; pull-ups {pullup:g} kΩ on every bus line.
Written by `instobj firmware`; `plan.h` holds all that belongs to this object.

    sudo apt install gcc-avr avr-libc binutils-avr make avrdude
    make
    make flash PORT=/dev/ttyACM0
    instobj collect FIRST --port /dev/ttyACM0 --baud {baud}

| sensor | part | multiplexer | address | supply |
|---|---|---|---|---|
{rows}

- A sensor that does not answer twice leaves its cells empty; it is started anew every second.
- A bus that hangs for 2.5 ms is clocked free and multiplexers are reset; if the data line stays low,
  sensors on supply pins lose their power and are started anew.
- The watchdog restarts the board after 2 s. Once a second a line `S` tells supply, errors, why the board
  started, and the temperature of every sensor (`instobj docs recordings`).
"""


def write_project(files: dict[str, str], folder: Path) -> list[Path]:
    """Write a project; files of an earlier one that it does not have are removed.

    Raises
    ------
    StoreError
        The folder cannot be written.
    """
    folder.mkdir(parents=True, exist_ok=True)
    for name in _DRIVERS:
        if name not in files:
            (folder / name).unlink(missing_ok=True)
    for name, text in files.items():
        with atomic_path(folder / name) as path:
            path.write_text(text, encoding="utf-8")
    return [folder / name for name in files]
