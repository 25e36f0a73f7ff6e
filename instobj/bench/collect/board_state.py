"""State of a board as it reports it, in words and as figures."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any

import numpy as np

from estimator.recordings.boards.lines import Status

_CELL_V = (3.3, 3.61, 3.73, 3.84, 3.98, 4.2)
_CHARGE = (0.0, 5.0, 20.0, 50.0, 75.0, 100.0)
"""Charge (%) of a lithium cell by its voltage, under little current: usual figures, an estimate."""
_FLATTEST_V, _FULLEST_V = 3.0, 4.3
"""Supplies between them are a lithium cell's; a board on a cable has 5 V."""
_LOW = 10.0
"""Charge (%) below which it is time to charge."""


def status_text(status: Status) -> str:
    """The board's own report: chips, supply and bus."""
    temperatures = [value for value in status.sensors_c if value == value]
    chips = (
        f"sensors {min(temperatures):.1f} to {max(temperatures):.1f} °C"
        if temperatures
        else "no sensor answers"
    )
    silent = len(status.sensors_c) - len(temperatures)
    supply = supply_text(status)
    return (
        f"board: {chips}, {silent} silent{supply and ', '}{supply}; {status.supply_errors} times too low a "
        f"supply at a sensor, {status.bus_errors} failed transfers, {status.bus_recoveries} times the bus "
        f"hung; last start by {status.start}"
    )


def supply_text(status: Status) -> str:
    """Return the supply in words, with the charge where it is a battery's; empty where it is not measured."""
    if status.supply_mv is None:
        return ""
    volts = status.supply_mv / 1e3
    if not _FLATTEST_V <= volts <= _FULLEST_V:
        return f"supply {volts:.2f} V"
    charge = float(np.interp(volts, _CELL_V, _CHARGE))
    return f"battery {volts:.2f} V, about {charge:.0f} %{': charge it' if charge < _LOW else ''}"


def status_row(status: Status) -> dict[str, Any]:
    """The same as figures; None for silent sensors."""
    celsius = [value if value == value else None for value in status.sensors_c]
    return {**asdict(status), "sensors_c": celsius}
