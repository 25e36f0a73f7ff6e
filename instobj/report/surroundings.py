"""What surroundings, temperature and switched coils do to the channels, as figures and as lines."""

from __future__ import annotations

from html import escape
from typing import Any

import numpy as np

from design.catalogue.magnets import NDFEB_REMANENCE_PER_KELVIN
from design.spec.object import ObjectSpec
from design.spec.sensors import fastest_frame_rate_hz

_GAPS_MM = (0.0, 10.0)


def surroundings_row(spec: ObjectSpec) -> dict[str, Any]:
    """Changes of resting channels in counts, worst over faces and channels, JSON-able."""
    from estimator.signals.presses import rest_counts
    from estimator.signals.surroundings import counts_of_states, surroundings

    found = surroundings(spec, _GAPS_MM)
    row: dict[str, Any] = {
        "earth_field_ut": found.earth_field_ut,
        "turning_largest_counts": round(found.turning_largest_counts, 1),
        "turning_rms_counts": round(found.turning_rms_counts, 1),
        "jaw_gap_mm": list(_GAPS_MM),
        "jaw_own_face_counts": _rounded(found.jaw_counts.max(axis=0)),
        "jaw_other_faces_counts": _rounded(found.jaw_elsewhere_counts.max(axis=0)),
        "fastest_frame_rate_hz": round(fastest_frame_rate_hz(spec.sensors), 1),
    }
    if spec.magnets.kind == "coil":
        states = counts_of_states(spec)
        own = states[scene_faces(spec) - 1, np.arange(states.shape[1])]
        row["coil_polarization_mt"] = round(1e3 * spec.magnets.winding_polarization_t, 3)
        row["own_coils_counts"] = round(float(abs(own).max()), 1)
        row["other_faces_coils_counts"] = round(float(abs(states[-1] - own).max()), 1)
    else:
        baseline = float(abs(rest_counts(spec)).max())
        row["baseline_counts_per_kelvin"] = round(NDFEB_REMANENCE_PER_KELVIN * baseline, 2)
    return row


def scene_faces(spec: ObjectSpec) -> np.ndarray:
    """The face of every sensor."""
    from design.layout.positions import sensor_layout

    return sensor_layout(spec).face


def surroundings_lines(row: dict[str, Any]) -> list[str]:
    """The same for people."""
    (touching, near), (touching_others, near_others) = (
        row[f"jaw_{whose}_counts"] for whose in ("own_face", "other_faces")
    )
    lines = [
        f"Earth's field of {row['earth_field_ut']:g} µT: turning the object changes a channel by up to "
        f"{row['turning_largest_counts']:g} counts ({row['turning_rms_counts']:g} rms)",
        f"steel jaw against a face: up to {touching:g} counts on its own channels and "
        f"{touching_others:g} on others; {row['jaw_gap_mm'][1]:g} mm away {near:g} and {near_others:g} "
        "(thick wide plate, an upper bound)",
    ]
    if "baseline_counts_per_kelvin" in row:
        lines.append(
            f"magnets 1 K warmer: {100 * NDFEB_REMANENCE_PER_KELVIN:.2f} % of every signal, up to "
            f"{row['baseline_counts_per_kelvin']:g} counts of a baseline"
        )
    else:
        lines.append(
            f"coils worth {row['coil_polarization_mt']:g} mT of polarization: up to "
            f"{row['own_coils_counts']:g} counts on their own face's channels; those of the other faces "
            f"add up to {row['other_faces_coils_counts']:g} where they are on too"
        )
    lines.append(f"sensors can be read at up to {row['fastest_frame_rate_hz']:g} Hz over the bus")
    return lines


def surroundings_section(spec: ObjectSpec) -> str:
    """The report's section: what looks like a press and is none."""
    items = "".join(
        f"<li>{escape(line)}</li>" for line in surroundings_lines(surroundings_row(spec))
    )
    return (
        "<h2>Surroundings</h2><p>What changes resting signals after they were zeroed, in counts; a "
        f"face's own estimator takes it for a press.</p><ul>{items}</ul>"
    )


def _rounded(values: np.ndarray) -> list[float]:
    return [round(float(value), 1) for value in values]
