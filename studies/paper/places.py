"""Errors per contact location, and their correlation with sensitivity."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Bool

from estimator.frames.splits import split_paper_random_frames
from studies.paper.figures import draw_maps, draw_scatter, headline
from studies.paper.object import (
    SIMULATED,
    SimulatedObject,
    fitted_to_split,
    predict_face,
    simulated_object,
)
from studies.registry import Study, StudyResult

if TYPE_CHECKING:
    from design.spec.object import ObjectSpec
    from estimator.metrics.heatmaps import FaceMetrics

AREAS = ("corner", "edge", "mid_edge", "centre")


def single_contact_metrics(recorded: SimulatedObject, face: int) -> FaceMetrics:
    """The model of `general-performance`, judged on its single-contact test frames alone."""
    from estimator.frames.contact_cases import DUAL_CASES
    from estimator.frames.face_data import face_data
    from estimator.metrics.heatmaps import face_metrics, force_reference

    frames = recorded.collect(faces=[face])
    label = {"collection": "paper", "faces": [face]}
    model, _, test = fitted_to_split(recorded, frames, split_paper_random_frames, face, label)
    span = force_reference(face_data(frames, face).heatmap_n)
    predicted, true, rest = predict_face(model, test.select(test.place_id < DUAL_CASES))
    return face_metrics(face, predicted, true, span, rest)


def area_places(shape: tuple[int, int], area: str) -> Bool[np.ndarray, "nx ny"]:
    """Return the places of an area of a grid: corners; edge, the outermost ring without corners; mid_edge,
    the middle third of each side; centre, the inner 4 × 4."""
    x, y = np.meshgrid(*map(np.arange, shape), indexing="ij")
    from_x, from_y = (abs(k - (n - 1) / 2) for k, n in zip((x, y), shape, strict=True))
    on_x, on_y = from_x == from_x.max(), from_y == from_y.max()
    return {
        "corner": on_x & on_y,
        "edge": on_x ^ on_y,
        "mid_edge": (on_x & (from_y <= shape[1] / 6)) | (on_y & (from_x <= shape[0] / 6)),
        "centre": (from_x < 2) & (from_y < 2),
    }[area]


def run_location_wise(spec: ObjectSpec, folder: Path, quick: bool) -> StudyResult:
    """Mean errors at every place of the first face, and by area."""
    from design.layout.places.contact_grid import contact_grid

    recorded = simulated_object(spec, quick)
    face = recorded.spec.collection.faces[0]
    maps = single_contact_metrics(recorded, face).maps
    grid = contact_grid(recorded.spec)
    shown = {
        "similarity A_sim": maps.similarity,
        "location error E_loc (px)": maps.location_error_px,
        "force error E_f (%)": maps.force_error_percent,
    }
    better = tuple(shown)[:1]
    title = headline(f"face {face}, single contacts", quick)
    draw_maps(shown, title, folder / "location-wise.png", more_is_better=better)
    rows = []
    for area in AREAS:
        inside = area_places(grid.shape, area) & (maps.contacts > 0)
        if not inside.any():
            continue
        means = {
            name: round(float(np.nanmean(values[inside])), 4) for name, values in shown.items()
        }
        rows.append({"area": area.replace("_", "-"), "places": int(inside.sum())} | means)
    texts = [
        SIMULATED,
        f"Face {face}, single contacts. The paper finds its errors at the mid-edges.",
    ]
    return StudyResult(rows, texts)


def run_sensitivity(spec: ObjectSpec, folder: Path, quick: bool) -> StudyResult:
    """δ and the Cramér–Rao bounds of every place beside the errors there, ranks compared."""
    from estimator.information.scores import score_places

    recorded = simulated_object(spec, quick)
    face = recorded.spec.collection.faces[0]
    scores = score_places(recorded.spec, recorded.signals)
    row = int(np.flatnonzero(scores.faces == face)[0])
    maps = single_contact_metrics(recorded, face).maps
    predictors = {
        "1 / δ, raw": 1 / scores.delta_raw[row],
        "1 / δ, scaled": 1 / scores.delta_scaled[row],
        "position bound (mm)": scores.position_bound_mm[row],
        "force bound (N)": scores.force_bound_n[row],
    }
    errors = {
        "E_f (%)": maps.force_error_percent.ravel(),
        "E_f (N)": maps.force_error_n.ravel(),
        "E_loc (px)": maps.location_error_px.ravel(),
        "1 − A_sim": 1 - maps.similarity.ravel(),
    }
    rows = [
        {"predictor": name}
        | {f"ranks as {error}": rank_correlation(value, found) for error, found in errors.items()}
        for name, value in predictors.items()
    ]
    title = headline(f"face {face}, single contacts", quick)
    _draw_sensitivity(predictors, errors, maps.similarity.shape, title, folder)
    texts = [
        SIMULATED,
        "Spearman's correlation of predictors with errors: +1 means that a predictor orders the "
        f"places as the errors do. δ from 1000 frames; "
        f"bounds at {recorded.spec.score.force_n:g} N. Face {face}.",
    ]
    return StudyResult(rows, texts)


def _draw_sensitivity(
    predictors: dict[str, np.ndarray],
    errors: dict[str, np.ndarray],
    shape: tuple[int, ...],
    title: str,
    folder: Path,
) -> None:
    delta, bound = 1 / predictors["1 / δ, raw"], predictors["position bound (mm)"]
    names = ("sensitivity δ, raw (counts⁹/N)", "position bound (mm)", "force error E_f (%)")
    values = (delta, bound, errors["E_f (%)"])
    shown = {name: value.reshape(shape) for name, value in zip(names, values, strict=True)}
    draw_maps(shown, title, folder / "force-sensitivity.png", names[:2], more_is_better=names[:1])
    pairs = (
        ("1 / δ, raw", "E_f (%)"),
        ("force bound (N)", "E_f (N)"),
        ("position bound (mm)", "E_f (%)"),
    )
    panels = [
        (
            a.replace("raw", "raw (N/counts⁹)"),
            f"error {b}",
            predictors[a],
            errors[b],
            rank_correlation(predictors[a], errors[b]),
        )
        for a, b in pairs
    ]
    draw_scatter(panels, title + ", one point per location", folder / "correlation.png")


def rank_correlation(a: np.ndarray, b: np.ndarray) -> float:
    """Spearman's, over what is finite in both; NaN where one does not vary."""
    from scipy.stats import rankdata

    kept = np.isfinite(a) & np.isfinite(b)
    ranks = [rankdata(values[kept]) for values in (a, b)]
    if min(np.ptp(rank) for rank in ranks) == 0:
        return float("nan")
    return round(float(np.corrcoef(*ranks)[0, 1]), 3)


STUDIES = (
    Study("location-wise", "Errors at every contact location of one face.", run_location_wise),
    Study(
        "force-sensitivity",
        "Maps of δ and the bounds, and how they rank the errors.",
        run_sensitivity,
    ),
)
