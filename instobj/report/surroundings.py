"""Surroundings and temperature in words: what changes channels without a press."""

from __future__ import annotations

from math import isinf, isnan
from typing import Any

from design.catalogue.magnets import NDFEB_REMANENCE_PER_KELVIN
from instobj.report.pages import render

JAW_HEADER = ("jaw", "counts", "false force, N", "pull on a magnet, N")
GRASP_HEADER = (
    "flat jaw over",
    "σ force, N",
    "σ centre, mm",
    "σ tilt, °",
    "σ size, mm",
    "15 min later",
    "mm",
    "°",
    "size, mm",
)
"""Bounds of a jaw, freshly zeroed and drifted."""
_NOTHING = (0.5, 1e-3, 1e-3)
"""Counts and newtons below which 0 is shown: no chip and no hand feels them."""


def surroundings_lines(row: dict[str, Any]) -> list[str]:
    """Lines for people of `surroundings_row`, and of the stage `surroundings`, which has more."""
    lines = [
        f"Earth's field of {row['earth_field_ut']:g} µT: turning the object changes a channel by up to "
        f"{_rounded(row['turning_largest_counts'])} counts ({_rounded(row['turning_rms_counts'])} rms)"
    ]
    if "jaws" not in row:
        lines.append(_steel_line(row))
    lines.append(
        f"Warming by 1 K: signals {100 * abs(NDFEB_REMANENCE_PER_KELVIN):.2f} % smaller, zero shifted by "
        f"up to {_rounded(abs(row['baseline_counts_per_kelvin']))} counts"
    )
    if row.get("resting"):
        resting = row["resting"]
        lines.append(
            f"Magnets push and pull each other with up to {_rounded(resting['force_n'])} N. In the silicone "
            f"this moves them by up to {_rounded(1e3 * resting['moved_mm'])} µm and the zero by up to "
            f"{_rounded(resting['counts'])} counts; zeroing takes that out"
        )
    lines.append(
        f"Sensors can be read at up to {_rounded(row['fastest_frame_rate_hz'])} Hz over the bus"
    )
    return lines


def _steel_line(row: dict[str, Any]) -> str:
    (touching, near), (touching_others, near_others) = (
        row[f"jaw_{whose}_counts"] for whose in ("own_face", "other_faces")
    )
    return (
        f"A steel gripper that touches shifts the zero of its face by up to {_rounded(touching)} counts and "
        f"of others by {_rounded(touching_others)}, and pulls a magnet with up to "
        f"{_rounded(row['jaw_pull_n'][0])} N; {row['jaw_gap_mm'][1]:g} mm away by {_rounded(near)} and "
        f"{_rounded(near_others)} (thick wide plate, an upper bound). No verdict counts this: take jaws of "
        "plastic or aluminium"
    )


def jaw_rows(row: dict[str, Any]) -> list[tuple[str, ...]]:
    """Rows of `JAW_HEADER` for the jaws that the stage `surroundings` stores."""
    rows = []
    for jaw in row["jaws"]:
        where = f"{jaw['gap_mm']:g} mm away" if jaw["gap_mm"] else "touching"
        figures = zip((jaw["counts"], jaw["false_force_n"], jaw["pull_n"]), _NOTHING, strict=True)
        texts = (_rounded(value) if value >= least else "0" for value, least in figures)
        rows.append((f"{jaw['material']}, {where}", *texts))
    return rows


def grasp_rows(row: dict[str, Any]) -> list[tuple[str, ...]]:
    """Rows of `GRASP_HEADER`: jaws over faces, their middles, opposed faces; none on curved bodies."""
    return [
        (
            (
                f"middle of face {jaw['face']}, half as long and wide"
                if jaw["covered"] < 1
                else f"face {jaw['face']}"
            )
            + (f", another over {jaw['against']}" if jaw["against"] else ""),
            *(
                _rounded(jaw[f"{name}_bound{state}_{unit}"])
                for state in ("", "_drifted")
                for name, unit in (
                    ("force", "n"),
                    ("centre", "mm"),
                    ("tilt", "deg"),
                    ("size", "mm"),
                )
            ),
        )
        for jaw in row["jaw_bounds"]
    ]


def _rounded(value: float) -> str:
    """Three figures, without an exponent; ∞ of what signals cannot tell, – of what there is none."""
    if isnan(value):
        return "–"
    if isinf(value):
        return "∞"
    return f"{value:.0f}" if abs(value) >= 100 else f"{value:.3g}"


def surroundings_section(row: dict[str, Any]) -> str:
    """The report's section: what looks like a press and is none."""
    return render(
        "surroundings.html.j2",
        lines=surroundings_lines(row),
        header=JAW_HEADER,
        jaws=jaw_rows(row),
    )
