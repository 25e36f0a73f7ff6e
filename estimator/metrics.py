"""The four metrics of Knopke et al. (RA-L 2024) on heatmaps, and the error of the total force.

With maps T (true) and P (predicted), each less its own mean, the zero-normalised
cross-correlation at displacement d is C(d) = Σ_u P(u + d) T(u) / (‖P‖ ‖T‖), zero outside.

- A_sim, `similarity`: the maximum of C over all displacements, in contact frames;
- E_loc, `location_error_px`: the displacement of that maximum;
- E_f, `force_error_n`: |P − T| at the true contact pixels, also in per cent of the range of
  force that the data set holds at that pixel;
- A_non, `non_contact_accuracy`: share of rest frames in which every pixel stays below 0.9 times
  the data set's smallest contact force.
"""

from __future__ import annotations

from dataclasses import dataclass, fields

import numpy as np
from jaxtyping import Bool, Float, Int

from design.errors import InputError

NON_CONTACT_SHARE = 0.9
_TIE = 1e-9
"""Correlations this close are equal: the shortest displacement among them is taken."""
_CHUNK_FRAMES = 4096


@dataclass(frozen=True)
class Alignment:
    """Best displacement of each predicted map against the true one.

    A map without any contrast (constant) has no correlation: its similarity is 0 and its
    displacement NaN.
    """

    similarity: Float[np.ndarray, "frame"]
    displacement_px: Float[np.ndarray, "frame 2"]


@dataclass(frozen=True)
class ForceReference:
    """What a data set says about forces: its smallest contact force (N), and the range of force
    (N) at each pixel, NaN where fewer than two different forces were seen."""

    smallest_contact_n: float
    range_n: Float[np.ndarray, "nx ny"]


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
    total_force_error_n: float
    non_contact_accuracy: float
    other_face_accuracy: float
    contact_frames: int
    rest_frames: int
    other_face_frames: int
    undefined_frames: int
    smallest_contact_n: float
    maps: PlaceMaps

    def summary(self) -> dict[str, float | int | None]:
        """Everything but the maps, ready for JSON (None where undefined)."""
        values = {f.name: getattr(self, f.name) for f in fields(self) if f.name != "maps"}
        return {name: None if value != value else value for name, value in values.items()}


def align(
    predicted_n: Float[np.ndarray, "frame nx ny"], true_n: Float[np.ndarray, "frame nx ny"]
) -> Alignment:
    """A_sim and the displacement of the best match, frame by frame (zero-padded, by FFT)."""
    chunks = [
        _align_chunk(
            predicted_n[start : start + _CHUNK_FRAMES], true_n[start : start + _CHUNK_FRAMES]
        )
        for start in range(0, max(1, len(true_n)), _CHUNK_FRAMES)
    ]
    return Alignment(
        np.concatenate([chunk.similarity for chunk in chunks]),
        np.concatenate([chunk.displacement_px for chunk in chunks]),
    )


def _align_chunk(
    predicted_n: Float[np.ndarray, "frame nx ny"], true_n: Float[np.ndarray, "frame nx ny"]
) -> Alignment:
    from scipy import fft

    p, t = _normalised(predicted_n), _normalised(true_n)
    nx, ny = t.shape[1:]
    size = (fft.next_fast_len(2 * nx - 1, real=True), fft.next_fast_len(2 * ny - 1, real=True))
    spectrum = np.asarray(fft.rfft2(p, size)) * np.asarray(fft.rfft2(t, size)).conj()
    correlation = np.asarray(fft.irfft2(spectrum, size))
    shifts = np.stack(
        np.meshgrid(np.arange(1 - nx, nx), np.arange(1 - ny, ny), indexing="ij"), -1
    ).reshape(-1, 2)
    shifts = shifts[np.argsort(np.hypot(*shifts.T), kind="stable")]
    by_distance = correlation[:, shifts[:, 0], shifts[:, 1]]
    best = by_distance.max(axis=1)
    chosen = np.argmax(by_distance >= best[:, None] - _TIE, axis=1)
    defined = np.any(p != 0, axis=(1, 2)) & np.any(t != 0, axis=(1, 2))
    return Alignment(
        np.where(defined, np.clip(best, -1.0, 1.0), 0.0),
        np.where(defined[:, None], shifts[chosen], np.nan).astype(float),
    )


def _normalised(maps: Float[np.ndarray, "frame nx ny"]) -> Float[np.ndarray, "frame nx ny"]:
    """Zero mean and unit norm; exactly zero where a map is constant up to rounding."""
    maps = np.asarray(maps, float)
    centred = maps - maps.mean(axis=(1, 2), keepdims=True)
    norm = np.sqrt(np.sum(centred**2, axis=(1, 2), keepdims=True))
    scale = np.abs(maps).max(axis=(1, 2), keepdims=True)
    constant = norm <= 1e-12 * scale
    return np.where(constant, 0.0, centred / np.where(constant, 1.0, norm))


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
    aligned = align(predicted_n[contact], true_n[contact])
    away = np.abs(aligned.displacement_px)
    frame, x, y = np.nonzero(true_n[contact])
    error_n = np.abs(predicted_n - true_n)[contact][frame, x, y]
    error_percent = 100 * error_n / reference.range_n[x, y]
    total = np.abs(predicted_n.sum(axis=(1, 2)) - true_n.sum(axis=(1, 2)))[contact]
    distance = np.hypot(away[:, 0], away[:, 1])
    per_contact = (aligned.similarity[frame], distance[frame], error_n, error_percent)
    return FaceMetrics(
        face=face,
        similarity=_mean(aligned.similarity),
        location_error_px=_mean(distance),
        location_error_x_px=_mean(away[:, 0]),
        location_error_y_px=_mean(away[:, 1]),
        force_error_n=_mean(error_n),
        force_error_percent=_mean(error_percent),
        total_force_error_n=_mean(total),
        non_contact_accuracy=_mean(quiet[resting]),
        other_face_accuracy=_mean(quiet[elsewhere]),
        contact_frames=int(contact.sum()),
        rest_frames=int(resting.sum()),
        other_face_frames=int(elsewhere.sum()),
        undefined_frames=int(np.isnan(distance).sum()),
        smallest_contact_n=reference.smallest_contact_n,
        maps=_place_maps(x, y, per_contact, true_n.shape[1:]),
    )


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
