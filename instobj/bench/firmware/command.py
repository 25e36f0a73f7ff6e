"""`instobj bench firmware`: a bus plan for an object on a board, and the firmware that reads it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from design.build.order_list import order_list, price_text
from design.catalogue.bus_parts import BOARDS
from design.errors import InputError
from design.spec_io import load_spec
from design.wiring.bus_limits import FAST_KHZ
from design.wiring.bus_plan import BusPlan, Choice, choose_plan, first_plan
from design.wiring.dealing import WAYS
from instobj.bench.firmware.project import project_files, write_project
from instobj.bench.firmware.settings import supply_text
from instobj.store.publish import file_rows, require_writable, run_folder


def write_firmware(
    spec_path: Path,
    board: str | None,
    way: str | None,
    lead_mm: float,
    out: Path,
    overrides: list[str],
) -> dict[str, Any]:
    """Choose the bus plan of a specification on a board and write its project, `runs/NAME/firmware_BOARD`.

    Without a name `first_plan` chooses the board, as for the assembly sheet.

    Raises
    ------
    InputError
        A bad specification, no such board or way, no plan that works, or a setting that the chip
        cannot take.
    """
    if way is not None and way not in WAYS:
        raise InputError(f"--topology {way!r} is not known. Choose one of {', '.join(WAYS)}")
    spec = load_spec(spec_path, overrides)
    first = first_plan(spec) if board is None else None
    # where no board can, the first one says why
    chosen = BOARDS.named(board or next(iter(BOARDS))) if first is None else first.board
    plan, choice = choose_plan(spec, chosen, lead_mm, way)
    files, orders = project_files(spec, plan), order_list(spec, plan)
    require_writable(out)
    written = write_project(files, run_folder(out, spec.name) / f"firmware_{chosen.name}")
    return {
        "command": "firmware",
        "board": plan.board.name,
        "way": plan.way,
        "texts": [
            *plan_texts(plan),
            f"orders.csv: {len(orders)} parts to buy for {price_text(orders)}",
        ],
        "tables": {"sensors": chip_rows(plan), "ways": way_rows(choice)},
        "files": file_rows(written),
    }


def plan_texts(plan: BusPlan) -> list[str]:
    """The plan in words."""
    time = plan.time
    texts = [
        f"{plan.board.title}: {len(plan.chips)} sensors by {plan.way}; {plan.pins} pins, "
        f"{plan.wires} wires, {plan.cost_eur:.2f} EUR of parts beside board and sensors",
        f"bus {plan.khz:g} kHz, {plan.capacitance_pf:.0f} pF on the largest line, pull-ups "
        f"{plan.pullup_kohm:g} kΩ",
        f"up to {time.fastest_hz:.1f} frames per second: {time.reading_ms:.1f} ms to read, "
        f"{time.line_ms:.1f} ms to send, {time.conversion_ms:.1f} ms to convert",
    ]
    if plan.load is not None:
        texts.append(
            f"load cell: {plan.load.title}; up to {plan.load.lines_hz:g} lines `L` a second take "
            f"{plan.time.loads_ms:.0f} ms of it"
        )
    if plan.imu is not None:
        texts.append(f"IMU: {plan.imu.name} at 0x{plan.imu.address:02X} of the first bus")
    if plan.khz < FAST_KHZ:
        texts.append(
            f"the bus runs at {plan.khz:g} kHz, not at {FAST_KHZ:g}: that much capacitance "
            " rises too slowly for it"
        )
    if len(plan.board.bauds) > 1:
        texts.append(f"read it with `instobj bench collect OUT --port PORT@{plan.baud}`")
    return texts


def chip_rows(plan: BusPlan) -> list[dict[str, Any]]:
    """One row per sensor: how it is reached."""
    return [
        {
            "sensor": chip.label,
            "part": chip.part,
            "bus": plan.board.buses[chip.bus].name,
            "multiplexer": "" if chip.multiplexer is None else f"0x{chip.multiplexer:02X}",
            "channel": "" if chip.channel is None else str(chip.channel),
            "address": f"0x{chip.address:02X}",
            "from": "" if chip.address == chip.factory else f"0x{chip.factory:02X}",
            "supply": supply_text(chip),
        }
        for chip in plan.chips
    ]


def way_rows(choice: Choice) -> list[dict[str, Any]]:
    """Every way with its cost, or the reason why it does not work."""
    rows = [
        {
            "way": plan.way,
            "pins": str(plan.pins),
            "wires": str(plan.wires),
            "parts, EUR": f"{plan.cost_eur:.2f}",
            "Hz": f"{plan.time.fastest_hz:.0f}",
            "why not": "",
        }
        for plan in choice.plans
    ]
    no = {"pins": "", "wires": "", "parts, EUR": "", "Hz": ""}
    return rows + [{"way": way, **no, "why not": why} for way, why in choice.refused]
