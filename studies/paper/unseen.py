"""Locations without labelled presses: networks alone, and with a digital twin."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from estimator.frames.splits import split_paper_random_frames
from studies.paper.figures import draw_bars, draw_maps, headline
from studies.paper.object import (
    SIMULATED,
    SimulatedObject,
    calibrated_parts,
    fitted,
    metric_row,
    predict_face,
    simulated_object,
)
from studies.paper.published import TABLE_II, beside
from studies.paper.reference import judged_frames, known_cases, reference_row
from studies.registry import Study, StudyResult

if TYPE_CHECKING:
    from design.spec.object import ObjectSpec
    from estimator.frames.dataset import FrameSet
    from estimator.metrics.heatmaps import ForceReference
    from estimator.networks.face_model import FaceModel

_TWINS = 16
_STRONG_N = 4.0


def run_seen_unseen(spec: ObjectSpec, folder: Path, quick: bool) -> StudyResult:
    """Trained on every second place in x and y; tested there and on all other places."""
    from estimator.frames.contact_cases import DUAL_CASES, paper_cases
    from estimator.frames.face_data import face_data
    from estimator.metrics.heatmaps import force_reference

    recorded = simulated_object(spec, quick)
    face = recorded.spec.collection.faces[0]
    frames = recorded.collect(faces=[face], non_contact_cases=1)
    frames = frames.select(frames.place_id < DUAL_CASES)
    seen = seen_places(frames)
    split = split_paper_random_frames(frames, recorded.spec.seed)
    span = force_reference(face_data(frames, face).heatmap_n)
    parts = frames.select(split.train & seen), frames.select(split.validation & seen)
    tested = {"seen": frames.select(split.test & seen), "unseen": frames.select(~seen)}
    single = [case for case in paper_cases(recorded.spec, face) if len(case.face) == 1]
    known = known_cases(recorded, face, single)
    bounds = {
        places: reference_row(judged_frames(recorded, face, part, known), span)
        for places, part in tested.items()
    }
    rows: list[dict[str, Any]] = []
    maps = {}
    for name, model in _models(recorded, parts, face, 2 if quick else _TWINS).items():
        for places, part in tested.items():
            row, errors = _place_row(model, part, span, recorded)
            found = beside(row, TABLE_II[places]) | bounds[places]
            rows.append({"model": name, "places": places} | found)
            if places == "unseen":
                maps[name] = errors
    away = headline("localisation error at locations without training presses (px)", quick)
    draw_maps(maps, away, folder / "unseen-places.png", alike=True)
    draw_bars(
        [row | {"test": f"{row['places']}, {row['model']}"} for row in rows],
        "test",
        {
            "force error (% of the location's range)": {
                "E_f %": "E_f",
                "best E_f %": "its bound",
                "total force %": "total force",
                "paper E_f %": "E_f, paper (real object)",
            }
        },
        headline("locations with and without training presses", quick),
        folder / "seen-unseen.png",
    )
    texts = [
        SIMULATED,
        "E_f is read at the true pixel alone: a force shared with the next pixel counts as lost. The "
        "total force and the localisation error do not depend on pixels.",
        "heatmap, position: outputs of the compact network, trained on the labelled locations alone; "
        "calibrated twin: heatmap, trained on the labelled locations and on presses that the design's twin, "
        "calibrated on them, simulates at all. The hidden twin's large deformation has the form that "
        "is calibrated; that of silicone follows it to about 10 %.",
        "The bound knows the object's signals at every location and judges each frame for itself.",
    ]
    return StudyResult(rows, texts)


def _models(
    recorded: SimulatedObject, parts: tuple[FrameSet, FrameSet], face: int, twins: int
) -> dict[str, FaceModel]:
    """Estimators of all kinds for the same labelled frames."""
    label = {"collection": "paper", "faces": [face], "places": "seen", "twins": 0}
    models = {
        output: fitted(recorded, parts, face, label, continuous=output == "position")
        for output in ("heatmap", "position")
    }
    wider = calibrated_parts(recorded, parts, face, twins)
    models["calibrated twin"] = fitted(recorded, wider, face, label | {"calibrated": twins})
    return models


def seen_places(frames: FrameSet) -> np.ndarray:
    """Frames at every second place in x and y, and those at rest."""
    pitch = frames.grid_x_mm[1] - frames.grid_x_mm[0]
    first = np.array([frames.grid_x_mm[0], frames.grid_y_mm[0]])
    index = np.round((np.nan_to_num(frames.contact_xy_mm[:, 0], nan=first[0]) - first) / pitch)
    even = (index.astype(int) % 2 == 0).all(axis=1)
    return even | (frames.place_id < 0)


def _place_row(
    model: FaceModel, tested: FrameSet, span: ForceReference, recorded: SimulatedObject
) -> tuple[dict[str, float | None], np.ndarray]:
    """Metrics with the estimated place's distance, and that distance as a map (px)."""
    from estimator.metrics.heatmaps import contact_errors, face_metrics

    predicted, true, rest = predict_face(model, tested)
    metrics = face_metrics(model.face, predicted, true, span, rest)
    strong = true.sum(axis=(1, 2)) >= _STRONG_N
    errors = contact_errors(predicted[strong], true[strong], span)
    distance, pixel = place_distance_px(model, tested, recorded.spec.contact_grid.pitch_mm)
    total, count = np.zeros(true.shape[1:]), np.zeros(true.shape[1:])
    np.add.at(total, tuple(pixel.T), distance)
    np.add.at(count, tuple(pixel.T), 1)
    mean = np.where(count > 0, total / np.maximum(count, 1), np.nan)
    away = {
        "E_loc px from 4 N": round(float(np.nanmean(errors.distance_px)), 4),
        "distance px": round(float(distance.mean()), 4),
    }
    return metric_row(metrics) | away, mean


def place_distance_px(
    model: FaceModel, frames: FrameSet, pitch_mm: float
) -> tuple[np.ndarray, np.ndarray]:
    """Distance of the estimated from the true centre of force, and the true pixel, by contact."""
    from estimator.frames.face_data import face_data
    from estimator.frames.heatmap import mm_to_pixel
    from estimator.networks.face_model import predict

    data = face_data(frames, model.face)
    data = data.select(data.contact)
    away = np.linalg.norm(predict(model, data.frames).xy_mm - data.centre_mm, axis=1)
    return away / pitch_mm, mm_to_pixel(data.centre_mm, frames.grid_x_mm, frames.grid_y_mm)


STUDIES = (
    Study(
        "seen-unseen", "The paper's Table II: locations without training presses.", run_seen_unseen
    ),
)
