"""`python -m studies cycles`: what small strain, elasticity, lag and relaxation explain of loading cycles."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

from estimator.recordings.formats.travel import read_travel

if TYPE_CHECKING:
    from studies.recorded.cycle_laws import LawScore


def cycles_in(folder: Path) -> dict[str, Any]:
    """Laws of force and field fitted to half of a recording's loading cycles, judged on the others.

    Raises
    ------
    InputError
        A damaged recording, or one without loads or cycles along one axis.
    """
    from studies.recorded.cycle_laws import (
        cycles_of,
        field_laws,
        force_laws,
        loop_shares,
    )

    cycles = cycles_of(read_travel(folder))
    force, field = force_laws(cycles), field_laws(cycles)
    lag = next(score.lag_s for score in force if score.law == "elastic, lag") or 0.0
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
        "force": [asdict(score) for score in force],
        "field": [asdict(score) for score in field],
        "tables": {
            "share explained of the load, judged cycles": [_row(score) for score in force],
            "share explained of the field, judged cycles": [_row(score) for score in field],
        },
        "texts": [
            f"{cycles.count} cycles of {cycles.travel_mm.max():.3g} mm along {cycles.axis}; work lost in "
            f"a cycle over work done: {loops.min():.2f} to {loops.max():.2f} as recorded"
            + ("; below 0 the load comes after the travel told" if loops.min() < 0 else "")
        ],
    }


def _row(score: LawScore) -> dict[str, Any]:
    return {
        "law": score.law,
        "explained": round(score.explained, 4),
        "ways exchanged": None if score.exchanged is None else round(score.exchanged, 4),
        "lag s": score.lag_s,
        "relaxation time s": score.time_s,
        "relaxing share": score.share,
    }
