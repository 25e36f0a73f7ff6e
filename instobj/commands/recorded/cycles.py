"""`instobj cycles`: what small strain, elasticity, lag and relaxation explain of loading cycles."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

from estimator.recordings.formats.travel import read_travel

if TYPE_CHECKING:
    from estimator.known_travel.cycles import Rung


def cycles_in(folder: Path) -> dict[str, Any]:
    """Laws of force and field fitted to half of a recording's loading cycles, judged on the others.

    Raises
    ------
    InputError
        A damaged recording, or one without loads or cycles along one axis.
    """
    from estimator.known_travel.cycles import cycles_of, field_ladder, force_ladder, loop_shares

    cycles = cycles_of(read_travel(folder))
    force, field = force_ladder(cycles), field_ladder(cycles)
    lag = next(rung.lag_s for rung in force if rung.law == "elastic, lag") or 0.0
    loops = loop_shares(cycles, 0.0)
    return {
        "command": "cycles",
        "recording": str(folder),
        "cycles": cycles.count,
        "axis": cycles.axis,
        "travel_mm": float(cycles.travel_mm.max()),
        "largest_load": float(cycles.load.max()),
        "loop_shares": {
            "as recorded": loops.tolist(),
            "at its lag": loop_shares(cycles, lag).tolist(),
        },
        "force": [asdict(rung) for rung in force],
        "field": [asdict(rung) for rung in field],
        "tables": {
            "share explained of the load, judged cycles": [_row(rung) for rung in force],
            "share explained of the field, judged cycles": [_row(rung) for rung in field],
        },
        "texts": [
            f"{cycles.count} cycles of {cycles.travel_mm.max():.3g} mm along {cycles.axis}; work lost in "
            f"a cycle over work done: {loops.min():.2f} to {loops.max():.2f} as recorded"
            + ("; below 0 the load comes after the travel told" if loops.min() < 0 else "")
        ],
    }


def _row(rung: Rung) -> dict[str, Any]:
    return {
        "law": rung.law,
        "explained": round(rung.explained, 4),
        "ways exchanged": None if rung.exchanged is None else round(rung.exchanged, 4),
        "lag s": rung.lag_s,
        "relaxation time s": rung.time_s,
        "relaxing share": rung.share,
    }
