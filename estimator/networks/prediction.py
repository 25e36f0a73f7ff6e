"""Predictions of an estimator as arrays; the same from torch and from an exported file."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Float, Int


@dataclass(frozen=True)
class Prediction:
    """Readings of frames in float64; `estimator.networks.network.Reading` explains each column.

    With an interval's cover of 90 %, the true force lies within `force_n` ± `force_halfwidth_n` and
    the true centre within `position_radius_mm` of `xy_mm` in 90 % of the frames of new presses.
    """

    heatmap_n: Float[np.ndarray, "frame axis nx ny"]
    force_n: Float[np.ndarray, "frame"]
    xy_mm: Float[np.ndarray, "frame 2"]
    contact: Float[np.ndarray, "frame"]
    force_halfwidth_n: Float[np.ndarray, "frame"]
    position_radius_mm: Float[np.ndarray, "frame"]
    novelty: Float[np.ndarray, "frame"]

    def __repr__(self) -> str:
        pressed = self.contact > 0.5
        largest = f", force up to {self.force_n[pressed].max():.3g} N" if pressed.any() else ""
        return (
            f"Prediction of {len(self.force_n)} frames, {int(pressed.sum())} with contact{largest}; "
            f"heatmap_n {self.heatmap_n.shape} N, force_n and force_halfwidth_n (frame,) N, "
            "xy_mm (frame, 2) and position_radius_mm (frame,) mm, contact and novelty (frame,)"
        )

    def spread(self, has_readings: Bool[np.ndarray, "all_frames"]) -> Prediction:
        """Spread these readings over the frames that have readings, NaN at all others."""
        columns = {}
        for name, values in vars(self).items():
            columns[name] = np.full((len(has_readings), *values.shape[1:]), np.nan)
            columns[name][has_readings] = values
        return Prediction(**columns)

    @property
    def novel(self) -> Bool[np.ndarray, "frame"]:
        """Frames whose signals lie beyond what training covers; their intervals are wider."""
        return self.novelty > NOVEL_FROM


@dataclass(frozen=True)
class ContactReadings:
    """Readings of a model in the contact frames of its face, with what was there.

    Attributes
    ----------
    true_force_n, force_n : (frame) total force, N
    away_mm : (frame) distance of the predicted centre of force from the true one
    presses : number of presses that the frames come from
    """

    face: int
    true_force_n: Float[np.ndarray, "frame"]
    force_n: Float[np.ndarray, "frame"]
    away_mm: Float[np.ndarray, "frame"]
    presses: int


@dataclass(frozen=True)
class ContactAnswers:
    """Answers of one estimator in the contact frames of the test: total force (N) and centre (mm)."""

    name: str
    force_n: Float[np.ndarray, "frame"]
    xy_mm: Float[np.ndarray, "frame 2"]


@dataclass(frozen=True)
class HeldOutAnswers:
    """Answers of the model (first) and of all baselines, with what was labelled.

    Attributes
    ----------
    true_force_n, true_xy_mm : (frame,), (frame, 2); N, mm
    span_n : (frame,) summed ranges of force of the pressed pixels, of which errors are per cent
    press_id, time_s : (frame,)
    grid_x_mm, grid_y_mm : contact grid of the face
    force_halfwidth_n : (frame,) of the model's interval
    interval_cover : share of presses that the interval is made for
    fitted_frames : training frames of each baseline
    """

    face: int
    true_force_n: Float[np.ndarray, "frame"]
    true_xy_mm: Float[np.ndarray, "frame 2"]
    span_n: Float[np.ndarray, "frame"]
    press_id: Int[np.ndarray, "frame"]
    time_s: Float[np.ndarray, "frame"]
    grid_x_mm: Float[np.ndarray, "nx"]
    grid_y_mm: Float[np.ndarray, "ny"]
    force_halfwidth_n: Float[np.ndarray, "frame"]
    interval_cover: float
    answers: tuple[ContactAnswers, ...]
    fitted_frames: dict[str, int]


UNITS = {
    "heatmap_n": "N",
    "force_n": "N",
    "xy_mm": "mm",
    "contact": "1",
    "force_halfwidth_n": "N",
    "position_radius_mm": "mm",
    "novelty": "1",
}
NOVEL_FROM = 1.0
"""Above this novelty, a frame is novel."""
