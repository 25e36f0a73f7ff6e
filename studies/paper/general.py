"""The paper's Table I and the linear regression on its project page, on the simulated object."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from estimator.frames.splits import split_paper_random_frames
from studies.paper.figures import draw_bars, draw_histograms, headline
from studies.paper.object import (
    SIMULATED,
    SimulatedObject,
    fitted_to_split,
    metric_row,
    predict_face,
    simulated_object,
)
from studies.paper.published import LINEAR, TABLE_I, beside
from studies.paper.reference import interval_row, judged_frames, reference_row
from studies.registry import Study, StudyResult

if TYPE_CHECKING:
    from design.spec.object import ObjectSpec
    from estimator.metrics.heatmaps import ContactErrors, FaceMetrics

_STRONG_N = 4.0
_PAPER = {"paper E_f %": "paper (real object)"}


def run_general(spec: ObjectSpec, folder: Path, quick: bool) -> StudyResult:
    """Every face, frames split at random as in the paper, beside the bound on the same frames."""
    recorded = simulated_object(spec, quick)
    rows, errors = [], {}
    for face in recorded.spec.collection.faces:
        row, errors[f"face {face}"] = _face_row(recorded, face)
        rows.append(row)
    draw_bars(
        rows,
        "face",
        {"force error E_f (%)": {"E_f %": "simulated", "best E_f %": "its bound", **_PAPER}},
        headline("one to three contacts, frames split at random", quick),
        folder / "general-performance.png",
    )
    draw_histograms(errors, headline("errors of the test frames", quick), folder / "errors.png")
    texts = [
        SIMULATED,
        "Frames split at random as in the paper, so frames of one press are in every part. The bound "
        "judges each frame for itself; a fit may beat it by knowing each case's zero.",
        "Intervals: share of contact frames that the 90 % intervals hold, their median half-width or "
        "radius, and that of the narrowest intervals with the posterior of the bound, in the same "
        "frames. The bound knows that contacts lie on the grid, so its radius may be 0.",
    ]
    return StudyResult(rows, texts)


def _face_row(recorded: SimulatedObject, face: int) -> tuple[dict[str, Any], ContactErrors]:
    from estimator.frames.face_data import face_data
    from estimator.metrics.heatmaps import contact_errors, face_metrics, force_reference
    from studies.paper.false_alarms import false_alarms, fixed_threshold_n

    label = {"collection": "paper", "faces": [face]}
    frames = recorded.collect(faces=[face])
    model, validation, test = fitted_to_split(
        recorded, frames, split_paper_random_frames, face, label
    )
    span = force_reference(face_data(frames, face).heatmap_n)
    known, _, rest = predict_face(model, validation)
    predicted, true, at_rest = predict_face(model, test)
    metrics = face_metrics(face, predicted, true, span, at_rest)
    contact = true.max(axis=(1, 2)) > 0
    errors = contact_errors(predicted[contact], true[contact], span)
    strong = errors.true_total_n >= _STRONG_N
    alarms = false_alarms(predicted, true, at_rest, fixed_threshold_n(known, rest, 0.01))
    judged = judged_frames(recorded, face, test)
    bound = reference_row(judged, span)
    row: dict[str, Any] = {"face": face, "frames": len(frames)}
    row |= beside(metric_row(metrics), TABLE_I.get(face, {}))
    row |= {
        "A_sim from 4 N": round(float(errors.similarity[strong].mean()), 4),
        "threshold N": round(alarms.threshold_n, 3),
        "false alarms %": round(100 * alarms.false_alarm_rate, 2),
        "missed %": round(100 * alarms.miss_rate, 2),
        "noticed from N": round(alarms.noticed_from_n, 3),
    }
    row |= bound
    row["E_f over bound"] = round(row["E_f %"] / bound["best E_f %"], 3)
    row |= interval_row(judged, model, recorded.spec.protocol.force_noise_n)
    return row, errors


def run_linear(spec: ObjectSpec, folder: Path, quick: bool) -> StudyResult:
    """Linear regression beside the network and chance, on the same frames of face 1."""
    from estimator.frames.face_data import face_data
    from estimator.metrics.heatmaps import face_metrics, force_reference
    from studies.paper.heatmap_baselines import linear_baseline, mean_map_baseline

    recorded = simulated_object(spec, quick)
    face = recorded.spec.collection.faces[0]
    frames = recorded.collect(faces=[face])
    span = force_reference(face_data(frames, face).heatmap_n)
    label = {"collection": "paper", "faces": [face]}
    rows: list[dict[str, Any]] = []
    split = split_paper_random_frames(frames, recorded.spec.seed)
    linear = linear_baseline(frames, face, split)
    rows.append({"estimator": "linear"} | _beside(linear, LINEAR))
    model, _, test = fitted_to_split(recorded, frames, split_paper_random_frames, face, label)
    metrics = face_metrics(face, *_pair(predict_face(model, test), span))
    rows.append({"estimator": "compact"} | _beside(metrics, {}))
    chance = mean_map_baseline(frames, face, split)
    rows.append({"estimator": "always the mean map"} | _beside(chance, {}))
    draw_bars(
        rows,
        "estimator",
        {
            "force error E_f (%)": {
                "E_f %": "simulated",
                "paper E_f %": "authors' page (real object)",
            }
        },
        headline(f"linear regression and the network, face {face}", quick),
        folder / "linear-baseline.png",
    )
    return StudyResult(rows, [SIMULATED])


def _pair(found: tuple[np.ndarray, np.ndarray, np.ndarray], span: Any) -> tuple[Any, ...]:
    predicted, true, rest = found
    return predicted, true, span, rest


def _beside(metrics: FaceMetrics, published: dict[str, float]) -> dict[str, Any]:
    return beside(metric_row(metrics), published)


STUDIES = (
    Study(
        "general-performance",
        "The paper's Table I: all faces, one to three contacts, frames split at random.",
        run_general,
    ),
    Study(
        "linear-baseline",
        "Linear regression beside the network, as on the authors' page.",
        run_linear,
    ),
)
