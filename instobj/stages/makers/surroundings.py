"""Effect of surroundings and temperature on resting channels, as figures."""

from __future__ import annotations

from typing import Any

import numpy as np

from design.catalogue.magnets import NDFEB_REMANENCE_PER_KELVIN
from design.spec.object import ObjectSpec
from design.spec.sensors import fastest_frame_rate_hz

_GAPS_MM = (0.0, 10.0)


def surroundings_row(spec: ObjectSpec) -> dict[str, Any]:
    """Changes of resting channels in counts, worst over faces and channels, JSON-able."""
    from estimator.signals.presses import rest_counts
    from estimator.signals.surroundings import surroundings

    changes = surroundings(spec, _GAPS_MM)
    row: dict[str, Any] = {
        "earth_field_ut": changes.earth_field_ut,
        "turning_largest_counts": round(changes.turning_largest_counts, 1),
        "turning_rms_counts": round(changes.turning_rms_counts, 1),
        "jaw_gap_mm": list(_GAPS_MM),
        "jaw_own_face_counts": _rounded(changes.jaw_counts.max(axis=0)),
        "jaw_other_faces_counts": _rounded(changes.jaw_elsewhere_counts.max(axis=0)),
        "jaw_pull_n": [float(f"{pull:.3g}") for pull in changes.jaw_pull_n.max(axis=0)],
        "fastest_frame_rate_hz": round(fastest_frame_rate_hz(spec.sensors), 1),
    }
    baseline = float(abs(rest_counts(spec)).max())
    row["baseline_counts_per_kelvin"] = round(NDFEB_REMANENCE_PER_KELVIN * baseline, 2)
    return row


def _rounded(values: np.ndarray) -> list[float]:
    return [round(float(value), 1) for value in values]
