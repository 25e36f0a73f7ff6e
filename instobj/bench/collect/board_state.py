"""State of a board as it reports it, in words and as figures."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any

from estimator.recordings.boards.lines import Status


def status_text(status: Status) -> str:
    """The board's own report: chips, supply and bus."""
    temperatures = [value for value in status.sensors_c if value == value]
    chips = (
        f"sensors {min(temperatures):.1f} to {max(temperatures):.1f} °C"
        if temperatures
        else "no sensor answers"
    )
    silent = len(status.sensors_c) - len(temperatures)
    supply = "" if status.supply_mv is None else f", supply {status.supply_mv / 1e3:.2f} V"
    return (
        f"board: {chips}, {silent} silent{supply}; {status.supply_errors} times too low a supply at a "
        f"sensor, {status.bus_errors} failed transfers, {status.bus_recoveries} times the bus hung; "
        f"last start by {status.start}"
    )


def status_row(status: Status) -> dict[str, Any]:
    """The same as figures; None for silent sensors."""
    celsius = [value if value == value else None for value in status.sensors_c]
    return {**asdict(status), "sensors_c": celsius}
