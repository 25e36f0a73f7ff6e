"""Metrics of trained estimators."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from design.errors import InputError
from estimator.frames.dataset import FrameSet
from estimator.frames.face_data import (
    FaceData,
    face_data,
    with_history,
)
from estimator.metrics.heatmaps import FaceMetrics, face_metrics, force_reference
from estimator.networks.face_model import FaceModel, predict, predict_heatmaps
from estimator.networks.prediction import ContactReadings, Prediction
from estimator.networks.training.data import with_contacts


@dataclass(frozen=True)
class IntervalReport:
    """Intervals on presses that neither trained nor calibrated the model: covers are shares of
    frames, widths medians over frames."""

    wanted_cover: float
    force_cover: float
    position_cover: float
    median_force_halfwidth_n: float
    median_position_radius_mm: float
    calibration_presses: int
    tested_presses: int


def evaluate_face(
    model: FaceModel, frames: FrameSet, dataset: FrameSet | None = None
) -> FaceMetrics:
    """Metrics of a model on frames (normally the test part).

    `dataset` gives the smallest contact force and each place's range of force; by default the
    frames themselves.

    Raises
    ------
    InputError
        The frames hold no usable frame of the face, or its contacts are on another grid.
    """
    _check_grid(model, frames)
    data = face_data(with_history(frames, model.history_frames), model.face)
    reference = force_reference(face_data(dataset or frames, model.face).heatmap_n)
    predicted_n = predict_heatmaps(model, data.frames)
    return face_metrics(model.face, predicted_n, data.heatmap_n, reference, data.rest)


def evaluate_intervals(model: FaceModel, frames: FrameSet) -> IntervalReport:
    """Cover and width of a model's intervals in the contact frames of one face.

    Raises
    ------
    InputError
        The frames hold no contact on the face.
    """
    data = _contacts_of(model, frames)
    prediction, missed_n, away_mm = interval_errors(model, data)
    return IntervalReport(
        wanted_cover=model.interval_cover,
        force_cover=float(np.mean(missed_n <= prediction.force_halfwidth_n)),
        position_cover=float(np.mean(away_mm <= prediction.position_radius_mm)),
        median_force_halfwidth_n=float(np.median(prediction.force_halfwidth_n)),
        median_position_radius_mm=float(np.median(prediction.position_radius_mm)),
        calibration_presses=model.interval_presses,
        tested_presses=len(np.unique(data.frames.press_id)),
    )


def evaluate_travel(model: FaceModel, frames: FrameSet, dataset: FrameSet) -> dict[str, float]:
    """Errors of a model's force on presses labelled by travel: as travel (mm), and in N with its interval.

    The travel of a force is that at which the labels of the same place in `dataset` have it, at most the
    deepest. `low_factor` and `high_factor` bound every force, the label's and the model's alike.

    Raises
    ------
    InputError
        The frames hold no contact on the face.
    """
    data = _contacts_of(model, frames)
    prediction, missed_n, _ = interval_errors(model, data)
    tested = data.frames
    assert tested.travel_mm is not None
    assert dataset.travel_mm is not None
    assert tested.force_factors is not None
    force_n = np.nan_to_num(dataset.force_n[..., 2]).sum(axis=1)
    missed_mm = np.zeros(len(missed_n))
    order = np.argsort(force_n)
    for place in np.unique(tested.place_id):
        rising = order[(dataset.place_id[order] == place) & (force_n[order] > 0)]
        rows, curve = tested.place_id == place, (force_n[rising], dataset.travel_mm[rising])
        read_mm = np.interp(prediction.force_n[rows], *curve)
        missed_mm[rows] = np.abs(read_mm - tested.travel_mm[rows])
    low, high = tested.force_factors.tolist()
    return {
        "mean_travel_error_mm": float(missed_mm.mean()),
        "mean_force_error_n": float(missed_n.mean()),
        "low_factor": low,
        "high_factor": high,
    }


def contact_readings(model: FaceModel, frames: FrameSet) -> ContactReadings:
    """Readings of a model in frames (normally the test part) with contact on its face.

    Raises
    ------
    InputError
        The frames hold no contact on the face.
    """
    data = _contacts_of(model, frames)
    prediction = predict(model, data.frames)
    return ContactReadings(
        model.face,
        data.heatmap_n.sum(axis=(1, 2)),
        prediction.force_n,
        np.linalg.norm(prediction.xy_mm - data.centre_mm, axis=1),
        len(np.unique(data.frames.press_id)),
    )


def _contacts_of(model: FaceModel, frames: FrameSet) -> FaceData:
    """Return the frames with contact on a model's face, as it reads them."""
    data = face_data(with_history(frames, model.history_frames), model.face)
    data = with_contacts(data, "tested")
    return data.select(data.contact)


def interval_errors(
    model: FaceModel, data: FaceData
) -> tuple[Prediction, Float[np.ndarray, "frame"], Float[np.ndarray, "frame"]]:
    """Predictions in contact frames, how far off the total force is (N) and the centre (mm)."""
    prediction = predict(model, data.frames)
    missed_n = np.abs(prediction.force_n - data.heatmap_n.sum(axis=(1, 2)))
    return prediction, missed_n, np.linalg.norm(prediction.xy_mm - data.centre_mm, axis=1)


def _check_grid(model: FaceModel, frames: FrameSet) -> None:
    for name in ("grid_x_mm", "grid_y_mm"):
        mine, theirs = getattr(model, name), getattr(frames, name)
        if mine.shape != theirs.shape or not np.allclose(mine, theirs, rtol=0, atol=1e-6):
            raise InputError(
                f"the model's {name} is {mine.tolist()}, the data set's {theirs.tolist()}. Evaluate "
                "on the contact grid that the model was trained on"
            )
