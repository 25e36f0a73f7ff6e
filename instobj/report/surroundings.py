"""Surroundings and temperature in words: what changes channels without a press."""

from __future__ import annotations

from typing import Any

from design.catalogue.magnets import NDFEB_REMANENCE_PER_KELVIN
from instobj.report.pages import render


def surroundings_lines(row: dict[str, Any]) -> list[str]:
    """Lines for people of the figures that the stage `surroundings` stores."""
    (touching, near), (touching_others, near_others) = (
        row[f"jaw_{whose}_counts"] for whose in ("own_face", "other_faces")
    )
    lines = [
        f"Earth's field of {row['earth_field_ut']:g} µT: turning the object changes a channel by up to "
        f"{_told(row['turning_largest_counts'])} counts ({_told(row['turning_rms_counts'])} rms)",
        f"A steel gripper that touches shifts the zero of its face by up to {_told(touching)} counts and "
        f"of others by {_told(touching_others)}; {row['jaw_gap_mm'][1]:g} mm away by {_told(near)} and "
        f"{_told(near_others)} (thick wide plate, an upper bound)",
    ]
    lines.append(
        f"Warming by 1 K: signals {100 * abs(NDFEB_REMANENCE_PER_KELVIN):.2f} % smaller, zero shifted by "
        f"up to {_told(abs(row['baseline_counts_per_kelvin']))} counts"
    )
    lines.append(
        f"Sensors can be read at up to {_told(row['fastest_frame_rate_hz'])} Hz over the bus"
    )
    return lines


def _told(value: float) -> str:
    """Three figures, without an exponent."""
    return f"{value:.0f}" if abs(value) >= 100 else f"{value:.3g}"


def surroundings_section(row: dict[str, Any]) -> str:
    """The report's section: what looks like a press and is none."""
    return render("surroundings.html.j2", lines=surroundings_lines(row))
