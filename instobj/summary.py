"""The few numbers of each stage that the command line and the report show."""

from __future__ import annotations

import json
import math
from typing import Any

from instobj.store import StoredResult


def summarize(results: dict[str, StoredResult]) -> dict[str, Any]:
    """Title → numbers (or rows of numbers) for the stages that have results. NaN becomes None."""
    makers = {
        "build": ("parts", _parts),
        "mesh": ("mesh", _json("mesh_quality.json")),
        "response": ("mechanics", _json("response.json")),
        "scores": ("bounds by area (medians over all faces, fresh zero)", _areas),
        "frames": ("simulated presses", _json("protocol.json")),
        "metrics": ("metrics on held-out presses (frames of contact and of rest)", _metrics),
    }
    return {
        title: _finite(make(results[stage]))
        for stage, (title, make) in makers.items()
        if stage in results
    }


def _json(name: str) -> Any:
    return lambda result: json.loads((result.folder / name).read_text(encoding="utf-8"))


def _parts(result: StoredResult) -> list[dict[str, Any]]:
    from design.manifest import BuildManifest

    return [
        {
            "part": part.name,
            "volume mm³": round(part.volume_mm3, 2),
            "box mm": " × ".join(f"{edge:g}" for edge in map(_rounded, part.size_mm)),
            "STL volume error %": round(100 * (part.stl_volume_mm3 / part.volume_mm3 - 1), 4),
            "watertight": part.stl_watertight,
        }
        for part in BuildManifest.read(result.folder).parts
    ]


def _rounded(value: float) -> float:
    return round(value, 3)


def _areas(result: StoredResult) -> list[dict[str, Any]]:
    from estimator.scores import load_scores_csv, summarize_areas

    scores = load_scores_csv(result.folder / "scores.csv")
    return [
        {
            "area": area.area,
            "places": area.places,
            "place mm": area.medians["position_bound_fresh_mm"],
            "force N": area.medians["force_bound_fresh_n"],
            "detect N": area.medians["detectable_force_fresh_n"],
            "δ": area.medians["delta_raw"],
            "/centre": area.ratio_to_centre["position_bound_fresh_mm"],
            "δ/centre": area.ratio_to_centre["delta_raw"],
        }
        for area in summarize_areas(scores)
    ]


_ESTIMATORS = {
    "faces": "network",
    "ridge_regression": "ridge",
    "mean_map": "chance",
}


def _metrics(result: StoredResult) -> list[dict[str, Any]]:
    content = json.loads((result.folder / "metrics.json").read_text(encoding="utf-8"))
    rows = [
        {
            "face": face["face"],
            "model": title,
            "A_sim": face["similarity"],
            "E_loc px": face["location_error_px"],
            "E_f %": face["force_error_percent"],
            "E_f N": face["force_error_n"],
            "total N": face["total_force_error_n"],
            "A_non": face["non_contact_accuracy"],
            "contact": face["contact_frames"],
            "rest": face["rest_frames"],
        }
        for key, title in _ESTIMATORS.items()
        for face in content[key]
    ]
    return sorted(rows, key=lambda row: row["face"])


def _finite(values: Any) -> Any:
    if isinstance(values, list):
        return [_finite(value) for value in values]
    if isinstance(values, dict):
        return {name: _finite(value) for name, value in values.items()}
    if isinstance(values, float) and not math.isfinite(values):
        return None
    return values
