"""The few numbers of each stage that the command line and the report show."""

from __future__ import annotations

import math
import statistics
from collections.abc import Callable
from pathlib import Path
from typing import Any

from design.build.order_list import price_text
from design.spec.object import ObjectSpec
from instobj.report.core_section import slip_rows
from instobj.report.remedies import DESIGN_STAGES, verdict_summary
from instobj.report.uncertainty import robustness_summary
from instobj.report.verdict import SCORES_TITLE, score_rows
from instobj.report.weak_areas import WEAK_TITLE, weak_rows
from instobj.store.content import StoredResult
from instobj.store.readers import (
    CALIBRATION,
    COLLECTION_SUMMARY,
    CONTACT_METRICS,
    CORE_TENSION,
    CROSS_FACE,
    DISCRETISATION,
    IDENTIFIABILITY,
    INVERTED_TWIN,
    MANIFEST,
    MESH_QUALITY,
    METRICS,
    ORDERS,
    PROTOCOL,
    PULLED_SUMMARY,
    RESPONSE_SIZE,
    SCORES,
    SHEAR_SCORES,
    SLIP,
    ResultFile,
)

_CONTACTS_TITLE = (
    "contacts found by inversion, means over frames. tips a face: on the face pressed most; distance: of "
    "found contacts from true ones; bound: what an unbiased estimator could reach; missed, ghosts: true "
    "contacts not found, and found ones that are none, per frame"
)
TWIN_TITLE = "calibrated twin (medians over labelled places)"
NETWORKS_TITLE = "what the networks are worth"
_METRICS_TITLE = (
    "force maps of held-out presses, by the paper's metrics. similarity (A_sim): 1 where the maps agree; "
    "shift (E_loc): of the whole map, in pixels of the contact grid; force error (E_f): where it is pressed, "
    "% of the range of force there; rest read (A_non): share of frames at rest that are read as rest"
)


def summarize(results: dict[str, StoredResult], spec: ObjectSpec | None = None) -> dict[str, Any]:
    """Title → numbers (or rows of numbers) for the stages that have results. NaN becomes None.

    `spec` belongs to the chain, None for a data set.
    """
    makers = (
        ("build", "parts", lambda result: part_rows(result.folder)),
        ("sheet", "price", _price),
        ("mesh", "mesh", _read(MESH_QUALITY)),
        ("response", "mechanics", _read(RESPONSE_SIZE)),
        ("presses", "tension at the sliding core, left out of the presses", _core_tension),
        ("discretisation", "discretisation error", _discretisation),
        ("scores", SCORES_TITLE, lambda result: score_rows(SCORES.read(result.folder))),
        ("scores", "read worse than the bound", _bound_text),
        ("scores", "not judged", _unreached),
        ("weak_areas", WEAK_TITLE, weak_rows),
        (
            "scores",
            "10 N on another face, in this face's own channels",
            lambda result: cross_face_rows(result.folder),
        ),
        ("shear_scores", "bounds with tangential forces (medians over all places)", _shear),
        ("slip", "cost of the core's slip", _slip),
        ("identify", identify_title(spec), _identify),
        ("frames", "simulated presses", _read(PROTOCOL)),
        ("collection", "simulated recordings", _read(COLLECTION_SUMMARY)),
        ("pulled_collection", "simulated recordings", _read(PULLED_SUMMARY)),
        ("networks", TWIN_TITLE, _calibration),
        ("metrics", NETWORKS_TITLE, _networks_in_short),
        ("metrics", _METRICS_TITLE, _metrics),
        (
            "metrics",
            "total force and place beside simple regressions, held-out presses (%: of the range of force "
            "there; Δ: less the model's, mean over presses, ± half of its 90 % range; below 0: better than "
            "the model)",
            _baselines,
        ),
        (
            "metrics",
            "intervals on held-out presses (medians of widths, which other presses set: those of stopping, "
            "where presses are few those of training too)",
            _intervals,
        ),
        (
            "metrics",
            "labels of travel, held-out presses (force: between low and high times)",
            _travel,
        ),
        ("inversion", TWIN_TITLE, _inverted_twin),
        ("contact_metrics", "frames read by inversion", _judged_frames),
        ("contact_metrics", _CONTACTS_TITLE, _contacts),
    )
    made = {
        title: _finite(make(results[stage])) for stage, title, make in makers if stage in results
    }
    if spec and "robustness" in results:
        made |= _finite(robustness_summary(spec, results["robustness"].folder))
    if spec and results.keys() >= {*DESIGN_STAGES}:
        made = {"verdict": verdict_summary(spec, results)} | made
    return {title: values for title, values in made.items() if values}


def _price(result: StoredResult) -> dict[str, str]:
    return {"all that is to be ordered": price_text(ORDERS.read(result.folder))}


def _slip(result: StoredResult) -> list[dict[str, Any]]:
    """Rows of both models; none where the core has not slipped."""
    if not SLIP.path(result.folder).exists():
        return []
    return slip_rows(SLIP.read(result.folder)["figures"])


def identify_title(spec: ObjectSpec | None) -> str:
    """Return what its numbers are medians of, with the force and the limit that they hold for."""
    force, limit = ("score.force_n", "limits.position_bound_mm")
    if spec is not None:
        force, limit = f"{spec.score.force_n:g} N", f"{spec.limits.position_bound_mm:g} mm"
    return (
        f"k contacts at once, each of {force} or what its deepest press reaches: medians over sets, worst "
        f"contact; ok: sets whose every contact is bounded within {limit}"
    )


def _read(file: ResultFile[Any]) -> Callable[[StoredResult], Any]:
    return lambda result: file.read(result.folder)


def _discretisation(result: StoredResult) -> dict[str, Any]:
    from instobj.report.uncertainty import summary_of

    return summary_of(DISCRETISATION.read(result.folder))


def _calibration(result: StoredResult) -> list[dict[str, Any]]:
    """Nothing where no twin was calibrated; faces without one have fewer numbers."""
    return _calibrated_faces(CALIBRATION.read(result.folder))


def _inverted_twin(result: StoredResult) -> list[dict[str, Any]]:
    """Return rows as `_calibration`."""
    return _calibrated_faces(INVERTED_TWIN.read(result.folder))


def _judged_frames(result: StoredResult) -> dict[str, Any]:
    content = CONTACT_METRICS.read(result.folder)
    return {name: value for name, value in content.items() if not isinstance(value, list)}


def _contacts(result: StoredResult) -> list[dict[str, Any]]:
    return CONTACT_METRICS.read(result.folder)["contacts"]


def _calibrated_faces(content: dict[str, Any] | None) -> list[dict[str, Any]]:
    rows = content["faces"] if content else []
    values = [(name, value) for row in rows for name, value in row.items()]
    names = dict.fromkeys(name for name, value in values if not isinstance(value, list))
    return [{name: row.get(name) for name in names} for row in rows]


def _core_tension(result: StoredResult) -> dict[str, float]:
    """Nothing where the shell is bonded."""
    return CORE_TENSION.read(result.folder) or {}


def part_rows(folder: Path) -> list[dict[str, Any]]:
    """Volume, size and surface of every part of a build."""
    return [
        {
            "part": part.name,
            "volume mm³": round(part.volume_mm3, 2),
            "box mm": "×".join(f"{round(edge, 1):g}" for edge in part.size_mm),
            "STL volume error %": round(100 * (part.stl_volume_mm3 / part.volume_mm3 - 1), 4),
            "watertight": part.stl_watertight,
        }
        for part in MANIFEST.read(folder).parts
    ]


def _bound_text(result: StoredResult) -> dict[str, str]:
    """Nothing where a reader reaches the bound everywhere."""
    text = SCORES.read(result.folder).exceeds_bound
    return {"place": text} if text else {}


def _unreached(result: StoredResult) -> dict[str, str]:
    """Nothing where every location reaches the force."""
    text = SCORES.read(result.folder).unreached
    return {"force": text} if text else {}


def cross_face_rows(folder: Path) -> list[dict[str, Any]]:
    """Rows of forces that faces read while another is pressed; no rows with one sensed face."""
    content = CROSS_FACE.read(folder)
    return [
        {
            "pressed": relation,
            "median σ": content[relation]["median_sigma"],
            "95 % below": content[relation]["percentile_95_sigma"],
            "largest σ": content[relation]["largest_sigma"],
            "false force N": content[relation]["median_false_force_n"],
            "95 % below, N": content[relation]["percentile_95_false_force_n"],
            "largest N": content[relation]["largest_false_force_n"],
        }
        for relation in ("adjacent", "opposite")
        if content[relation]
    ]


def _shear(result: StoredResult) -> list[dict[str, Any]]:
    from estimator.information.fisher import SUFFIXES

    all_rows = SHEAR_SCORES.read(result.folder)
    rows = [row for row in all_rows if not math.isnan(float(row["position_bound_mm"]))]
    return [
        {
            "zero": state,
            "place mm": _median(rows, f"position_bound{suffix}_mm"),
            "normal N": _median(rows, f"normal_force_bound{suffix}_n"),
            "tangential N": _median(rows, f"tangential_force_bound{suffix}_n"),
            "tangential N, largest": max(
                float(row[f"tangential_force_bound{suffix}_n"]) for row in rows
            ),
        }
        for state, suffix in SUFFIXES.items()
    ]


def _identify(result: StoredResult) -> list[dict[str, Any]]:
    return [
        {
            "k": int(row["contacts"]),
            "sens.": int(row["sensors"]),
            "reads": row["channels"],
            "rank": f"{row['rank_least']} of {row['unknowns']}",
            "cond.": float(row["condition_median"]),
            "bound mm": float(row["bound_median_mm"]),
            "90 % mm": float(row["bound_90_mm"]),
            "bound N": float(row["force_bound_median_n"]),
            "ok %": round(100 * float(row["bound_share_within_limit"]), 1),
        }
        for row in IDENTIFIABILITY.read(result.folder)
    ]


def _median(rows: list[dict[str, str]], name: str) -> float:
    return statistics.median(float(row[name]) for row in rows)


def _metrics(result: StoredResult) -> list[dict[str, Any]]:
    return [
        {
            "face": face["face"],
            "similarity": face["similarity"],
            "shift px": face["location_error_px"],
            "force error %": face["force_error_percent"],
            "force error N": face["force_error_n"],
            "total force error N": face["total_force_error_n"],
            "rest read": face["non_contact_accuracy"],
            "frames pressed": face["contact_frames"],
            "frames at rest": face["rest_frames"],
        }
        for face in METRICS.read(result.folder)["faces"]
    ]


def _networks_in_short(result: StoredResult) -> dict[str, str]:
    """Say for each face how far its network errs, and which simple regression surely errs less."""
    rows, lines = METRICS.read(result.folder)["baselines"], {}
    for model in (row for row in rows if row["name"] == "model"):
        text = _errors_text(model)
        better = [row for row in rows if row["face"] == model["face"] and _errs_surely_less(row)]
        if better:
            best = min(better, key=lambda row: row["total_force_n"])
            text += (
                f". Better in force here: {best['name']}, {_errors_text(best)}. Networks need more "
                "presses, or the object's specification (--twin)"
            )
        lines[f"face {model['face']}"] = text
    return lines


def _errors_text(row: dict[str, Any]) -> str:
    place = "" if row["place_mm"] is None else f", place within {row['place_mm']:.2g} mm"
    return f"force within {row['total_force_n']:.2g} N{place} (means over {row['presses']} held-out presses)"


def _errs_surely_less(row: dict[str, Any]) -> bool:
    """Return whether the interval of the difference of forces to the model's lies below 0."""
    return row["name"] != "model" and row["force_n_less_model"]["high"] < 0


def _baselines(result: StoredResult) -> list[dict[str, Any]]:
    return [
        {
            "face": row["face"],
            "estimator": row["name"],
            "force %": row["total_force_percent"],
            "force N": row["total_force_n"],
            **difference_row(row, "force_n_less_model", "N"),
            "place mm": row["place_mm"],
            **difference_row(row, "place_mm_less_model", "mm"),
        }
        for row in METRICS.read(result.folder)["baselines"]
    ]


def difference_row(row: dict[str, Any], name: str, unit: str) -> dict[str, str]:
    """Mean difference over presses and half of its 90 % range, which one press does not have."""
    difference, is_model, alone = row[name], row["name"] == "model", row["presses"] < 2
    half = (difference["high"] - difference["low"]) / 2
    return {
        f"Δ {unit}": "–" if is_model else f"{difference['mean']:+.2f}",
        f"± {unit}": "–" if is_model or alone else f"{half:.2f}",
    }


def _intervals(result: StoredResult) -> list[dict[str, Any]]:
    content = METRICS.read(result.folder)
    return [
        {
            "face": row["face"],
            "wanted": row["wanted_cover"],
            "force covered": row["force_cover"],
            "place covered": row["position_cover"],
            "± N": row["median_force_halfwidth_n"],
            "radius mm": row["median_position_radius_mm"],
            "widths set on presses": row["calibration_presses"],
            "checked on held-out presses": row["tested_presses"],
        }
        for row in content["intervals"]
    ]


def _travel(result: StoredResult) -> list[dict[str, Any]]:
    """Rows of data sets that a machine labelled by its travel; none of others."""
    names = ("face", "travel mm", "force N", "low ×", "high ×")
    rows = METRICS.read(result.folder).get("travel", [])
    return [dict(zip(names, row.values(), strict=True)) for row in rows]


def _finite(values: Any) -> Any:
    if isinstance(values, list):
        return [_finite(value) for value in values]
    if isinstance(values, dict):
        return {name: _finite(value) for name, value in values.items()}
    if isinstance(values, float) and not math.isfinite(values):
        return None
    return values
