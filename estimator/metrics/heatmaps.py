"""The four metrics of Knopke et al. (RA-L 2024) on heatmaps, and the error of the total force.

- A_sim, `similarity`: the maximum over all displacements of the zero-normalised cross-correlation
  between predicted and true map (`estimator.metrics.cross_correlation`), in contact frames;
- E_loc, `location_error_px`: the displacement of that maximum;
- E_f, `force_error_n`: |P − T| at the true contact pixels, also in per cent of the range of
  force that the data set holds at that pixel; the total force likewise, over all pixels, in per
  cent of the summed ranges of the true contact pixels;
- displaced E_f, `displaced_force_error_percent`: the same with the predicted map first moved back by
  that displacement, in frames with a similarity of 0.3 or more. The paper's figures of its gripper and
  of unseen places are read so; it forgives a force at the wrong place;
- A_non, `non_contact_accuracy`: share of rest frames in which every pixel stays below 0.9 times
  the data set's smallest contact force.
"""

from __future__ import annotations

from dataclasses import dataclass, fields

import numpy as np
from jaxtyping import Bool, Float, Int

from design.errors import InputError
from estimator.metrics.cross_correlation import Alignment, align

NON_CONTACT_SHARE = 0.9
LEAST_SIMILARITY = 0.3
"""Below which the displaced force error leaves a frame out."""


@dataclass(frozen=True)
class ForceReference:
    """Scales that a data set gives forces: its smallest contact force (N), and the range of force
    (N) at each pixel, NaN where fewer than two different forces were seen."""

    smallest_contact_n: float
    range_n: Float[np.ndarray, "nx ny"]


@dataclass(frozen=True)
class ContactErrors:
    """Errors of contact frames and, from `frame` on, of the contacts in them.

    `similarity` (frame,); `displacement_px` (frame, 2), NaN where undefined; `total_n`,
    `total_percent` (frame,) of the total force, `true_total_n` itself. For every contact: its
    `frame`, pixel `x`, `y`, and `force_n`, `force_percent`, NaN without a range; `displaced_percent`,
    NaN too where the frame is left out.
    """

    similarity: Float[np.ndarray, "frame"]
    displacement_px: Float[np.ndarray, "frame 2"]
    total_n: Float[np.ndarray, "frame"]
    total_percent: Float[np.ndarray, "frame"]
    true_total_n: Float[np.ndarray, "frame"]
    frame: Int[np.ndarray, "contact"]
    x: Int[np.ndarray, "contact"]
    y: Int[np.ndarray, "contact"]
    force_n: Float[np.ndarray, "contact"]
    force_percent: Float[np.ndarray, "contact"]
    displaced_percent: Float[np.ndarray, "contact"]

    @property
    def distance_px(self) -> Float[np.ndarray, "frame"]:
        """E_loc of every frame."""
        return np.hypot(self.displacement_px[:, 0], self.displacement_px[:, 1])


@dataclass(frozen=True)
class PlaceMaps:
    """Means over the contacts at each pixel; NaN where there was none."""

    similarity: Float[np.ndarray, "nx ny"]
    location_error_px: Float[np.ndarray, "nx ny"]
    force_error_n: Float[np.ndarray, "nx ny"]
    force_error_percent: Float[np.ndarray, "nx ny"]
    contacts: Int[np.ndarray, "nx ny"]


@dataclass(frozen=True)
class FaceMetrics:
    """Metrics of one face; means over contact frames (force errors: over contacts), NaN if none.

    `undefined_frames` counts contact frames whose predicted map was constant: they count as
    similarity 0 and are left out of the location error. `other_face_accuracy` is A_non in frames
    where only other faces are pressed.
    """

    face: int
    similarity: float
    location_error_px: float
    location_error_x_px: float
    location_error_y_px: float
    force_error_n: float
    force_error_percent: float
    displaced_force_error_percent: float
    total_force_error_n: float
    total_force_error_percent: float
    non_contact_accuracy: float
    other_face_accuracy: float
    contact_frames: int
    rest_frames: int
    other_face_frames: int
    undefined_frames: int
    smallest_contact_n: float
    maps: PlaceMaps

    def __repr__(self) -> str:
        return (
            f"FaceMetrics of face {self.face}, {self.contact_frames} contact frames: total force "
            f"±{self.total_force_error_n:.3g} N ({self.total_force_error_percent:.3g} %), location "
            f"±{self.location_error_px:.3g} pixels, similarity {self.similarity:.3g}; "
            f"{self.rest_frames} rest frames, {self.non_contact_accuracy:.3g} read as rest"
        )

    def summary(self) -> dict[str, float | int | None]:
        """Everything but the maps, ready for JSON (None where undefined)."""
        values = {f.name: getattr(self, f.name) for f in fields(self) if f.name != "maps"}
        return {name: None if value != value else value for name, value in values.items()}


def force_reference(true_n: Float[np.ndarray, "frame nx ny"]) -> ForceReference:
    """Smallest contact force and ranges of force of a whole data set's true heatmaps.

    Raises
    ------
    InputError
        No heatmap holds a contact.
    """
    contact = true_n > 0
    if not contact.any():
        raise InputError(
            "metrics of force need contacts; got heatmaps that are all zero. Give frames that hold "
            "presses"
        )
    highest = true_n.max(axis=0)
    lowest = np.min(true_n, axis=0, where=contact, initial=np.inf)
    span = np.where(highest > lowest, highest - np.where(highest > 0, lowest, 0.0), np.nan)
    return ForceReference(float(true_n[contact].min()), span)


def face_metrics(
    face: int,
    predicted_n: Float[np.ndarray, "frame nx ny"],
    true_n: Float[np.ndarray, "frame nx ny"],
    reference: ForceReference,
    rest: Bool[np.ndarray, "frame"] | None = None,
) -> FaceMetrics:
    """All metrics of one face.

    Parameters
    ----------
    predicted_n, true_n : (frame, nx, ny), N
    reference : of the whole data set, not of the test frames alone
    rest : frames in which no face is pressed; by default all whose true map is zero. Frames with
        a zero map that are not at rest have other faces pressed and are judged apart.
    """
    contact = true_n.max(axis=(1, 2)) > 0
    resting = ~contact if rest is None else rest & ~contact
    quiet = predicted_n.max(axis=(1, 2)) < NON_CONTACT_SHARE * reference.smallest_contact_n
    elsewhere = ~contact & ~resting
    errors = contact_errors(predicted_n[contact], true_n[contact], reference)
    away = np.abs(errors.displacement_px)
    per_contact = (
        errors.similarity[errors.frame],
        errors.distance_px[errors.frame],
        errors.force_n,
        errors.force_percent,
    )
    return FaceMetrics(
        face=face,
        similarity=_mean(errors.similarity),
        location_error_px=_mean(errors.distance_px),
        location_error_x_px=_mean(away[:, 0]),
        location_error_y_px=_mean(away[:, 1]),
        force_error_n=_mean(errors.force_n),
        force_error_percent=_mean(errors.force_percent),
        displaced_force_error_percent=_mean(errors.displaced_percent),
        total_force_error_n=_mean(errors.total_n),
        total_force_error_percent=_mean(errors.total_percent),
        non_contact_accuracy=_mean(quiet[resting]),
        other_face_accuracy=_mean(quiet[elsewhere]),
        contact_frames=int(contact.sum()),
        rest_frames=int(resting.sum()),
        other_face_frames=int(elsewhere.sum()),
        undefined_frames=int(np.isnan(errors.distance_px).sum()),
        smallest_contact_n=reference.smallest_contact_n,
        maps=_place_maps(errors.x, errors.y, per_contact, true_n.shape[1:]),
    )


def contact_errors(
    predicted_n: Float[np.ndarray, "frame nx ny"],
    true_n: Float[np.ndarray, "frame nx ny"],
    reference: ForceReference,
) -> ContactErrors:
    """Errors one by one, of frames that all hold a contact."""
    aligned = align(predicted_n, true_n)
    frame, x, y = np.nonzero(true_n)
    force = np.abs(predicted_n - true_n)[frame, x, y]
    spans = np.zeros(len(true_n))
    np.add.at(spans, frame, reference.range_n[x, y])
    total = np.abs(predicted_n.sum(axis=(1, 2)) - true_n.sum(axis=(1, 2)))
    return ContactErrors(
        aligned.similarity,
        aligned.displacement_px,
        total,
        100 * total / spans,
        true_n.sum(axis=(1, 2)),
        frame,
        x,
        y,
        force,
        100 * force / reference.range_n[x, y],
        100 * _displaced(aligned, predicted_n, true_n) / reference.range_n[x, y],
    )


def _displaced(
    aligned: Alignment,
    predicted_n: Float[np.ndarray, "frame nx ny"],
    true_n: Float[np.ndarray, "frame nx ny"],
) -> Float[np.ndarray, "contact"]:
    """|P − T| with P read at the displacement of its best match; 0 N beyond the map's border."""
    frame, x, y = np.nonzero(true_n)
    kept = aligned.similarity[frame] >= LEAST_SIMILARITY
    away = np.where(kept[:, None], aligned.displacement_px[frame], 0.0).astype(int)
    read_px = np.stack([x, y], axis=1) + away
    inside = np.all((read_px >= 0) & (read_px < true_n.shape[1:]), axis=1)
    i, j = np.where(inside[:, None], read_px, 0).T
    read = np.where(inside, predicted_n[frame, i, j], 0.0)
    return np.where(kept, np.abs(read - true_n[frame, x, y]), np.nan)


def _place_maps(
    x: Int[np.ndarray, "contact"],
    y: Int[np.ndarray, "contact"],
    per_contact: tuple[Float[np.ndarray, "contact"], ...],
    shape: tuple[int, ...],
) -> PlaceMaps:
    contacts = np.zeros(shape, dtype=int)
    np.add.at(contacts, (x, y), 1)
    means = [_pixel_mean(x, y, values, shape) for values in per_contact]
    return PlaceMaps(means[0], means[1], means[2], means[3], contacts)


def _pixel_mean(
    x: Int[np.ndarray, "contact"],
    y: Int[np.ndarray, "contact"],
    values: Float[np.ndarray, "contact"],
    shape: tuple[int, ...],
) -> Float[np.ndarray, "nx ny"]:
    defined = ~np.isnan(values)
    total, count = np.zeros(shape), np.zeros(shape)
    np.add.at(total, (x[defined], y[defined]), values[defined])
    np.add.at(count, (x[defined], y[defined]), 1.0)
    return np.where(count > 0, total / np.maximum(count, 1), np.nan)


def _mean(values: Float[np.ndarray, "n"] | Bool[np.ndarray, "n"]) -> float:
    """Mean of what is defined, NaN where nothing is."""
    defined = values[~np.isnan(values)]
    return float(defined.mean()) if len(defined) else float("nan")
