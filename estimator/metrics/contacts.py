"""Contacts found against contacts true, one by one: distances in mm, numbers, forces, coverage.

What the metrics of heatmaps (`estimator.metrics.heatmaps`) cannot see: pixels of 3 mm hide errors of
tenths of a millimetre, and maps have no number of contacts. On every face true and found contacts
are paired so that the distances add up to the least (Kuhn, Nav. Res. Logist. Q. 2, 1955).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Float, Int

from estimator.frames.dataset import NO_FACE, FrameSet
from estimator.frames.windows import all_counts
from estimator.inversion.inversion import Inversion
from estimator.inversion.model.forward import NONE
from estimator.inversion.posterior import curvature_at
from estimator.inversion.readings import ContactSets

FORCE_BANDS_N = ((0.0, 1.0), (1.0, 4.0), (4.0, np.inf))
"""Bands of the force that the most heavily pressed face bears."""
FAR_MM = 5.0
"""A pair further apart counts as one contact missed and one ghost."""


@dataclass(frozen=True)
class MatchedContacts:
    """Frames, and the pairs of true and found contacts in them.

    Attributes
    ----------
    true_number, found_number : (frame,) contacts on all faces
    right : (frame,) as many contacts on every face as there are
    face_force_n : (frame,) largest true force of a face
    total_error_n : (frame,) found minus true normal force of all contacts
    tips : (frame,) true contacts of the face that has most
    explained : (frame,) the signals are those of contacts that the model knows
    frame, distance_mm, force_error_n : (pair,)
    pull_error_n, pull_n : (pair,) of the tangential force, NaN where none is read, and its true size
    place_covered, force_covered : (pair,) the true value lies in the 90 % region
    """

    true_number: Int[np.ndarray, "frame"]
    found_number: Int[np.ndarray, "frame"]
    right: Bool[np.ndarray, "frame"]
    face_force_n: Float[np.ndarray, "frame"]
    total_error_n: Float[np.ndarray, "frame"]
    tips: Int[np.ndarray, "frame"]
    explained: Bool[np.ndarray, "frame"]
    frame: Int[np.ndarray, "pair"]
    distance_mm: Float[np.ndarray, "pair"]
    force_error_n: Float[np.ndarray, "pair"]
    pull_error_n: Float[np.ndarray, "pair"]
    pull_n: Float[np.ndarray, "pair"]
    place_covered: Bool[np.ndarray, "pair"]
    force_covered: Bool[np.ndarray, "pair"]


def matched_contacts(frames: FrameSet, contact_sets: ContactSets) -> MatchedContacts:
    """Pair what was found in frames with what is true; forces are what each tip really bears,
    where the data set knows them, else the labels."""
    true_n = frames.force_n if frames.true_force_n is None else frames.true_force_n
    force = np.nan_to_num(true_n[..., 2])
    radius, halfwidth = contact_sets.position_radius_mm, contact_sets.force_halfwidth_n
    faces = frames.faces.tolist()
    pairs = []
    for row in range(len(frames)):
        for face in faces:
            (true,) = np.nonzero(frames.contact_face[row] == face)
            (mine,) = np.nonzero(contact_sets.face[row] == face)
            for t, m, distance in _paired(
                frames.contact_xy_mm[row, true], contact_sets.xy_mm[row, mine], true, mine
            ):
                missed = contact_sets.force_n[row, m] - force[row, t]
                covered = distance <= radius[row, m], abs(missed) <= halfwidth[row, m]
                pull = np.nan_to_num(true_n[row, t, :2])
                pull_error = np.linalg.norm(contact_sets.tangential_n[row, m] - pull)
                pulled = pull_error, np.linalg.norm(pull)
                pairs.append((row, distance, missed, *pulled, *covered))
    columns = np.array(pairs, float).reshape(-1, 7).T
    per_face = np.stack([_force_on_face(frames.contact_face == f, force) for f in faces], axis=1)
    tips = np.stack([np.sum(frames.contact_face == f, axis=1) for f in faces], axis=1)
    found_tips = np.stack([np.sum(contact_sets.face == f, axis=1) for f in faces], axis=1)
    return MatchedContacts(
        tips.sum(axis=1),
        contact_sets.number,
        np.all(tips == found_tips, axis=1),
        per_face.max(axis=1),
        np.nansum(contact_sets.force_n, axis=1) - per_face.sum(axis=1),
        tips.max(axis=1),
        contact_sets.explained,
        columns[0].astype(int),
        columns[1],
        *columns[2:5],
        *columns[5:].astype(bool),
    )


def _paired(
    true_mm: np.ndarray, found_mm: np.ndarray, true: np.ndarray, found_tips: np.ndarray
) -> list[tuple[int, int, float]]:
    from scipy.optimize import linear_sum_assignment

    if not len(true) or not len(found_tips):
        return []
    distance = np.linalg.norm(true_mm[:, None] - found_mm[None], axis=2)
    rows, columns = linear_sum_assignment(distance)
    return [
        (int(true[r]), int(found_tips[c]), float(distance[r, c]))
        for r, c in zip(rows, columns, strict=True)
    ]


def _force_on_face(is_on_face: np.ndarray, force_n: np.ndarray) -> Float[np.ndarray, "frame"]:
    return np.where(is_on_face, force_n, 0.0).sum(axis=1)


def rows_beside_bound(
    inversion: Inversion,
    frames: FrameSet,
    contact_sets: ContactSets,
    averaged: Int[np.ndarray, "frame"] | None = None,
) -> list[dict[str, float | int | str | None]]:
    """`contact_rows` of what an estimator found in labelled frames, or in the means of a number of them, with
    the distances possible."""
    possible_mm = possible_distance_mm(inversion, frames, averaged)
    return contact_rows(matched_contacts(frames, contact_sets), possible_mm)


def contact_rows(
    matched: MatchedContacts, possible_mm: Float[np.ndarray, "frame"] | None = None
) -> list[dict[str, float | int | str | None]]:
    """One row for each number of tips on the most pressed face and each band of its force, rest last.

    `possible_mm` is the mean distance that the Cramér–Rao bound leaves in each frame.
    """
    rows = []
    for tips in np.unique(matched.tips[matched.tips > 0]).tolist():
        for low, high in FORCE_BANDS_N:
            force = matched.face_force_n
            chosen = (matched.tips == tips) & (force >= low) & (force < high)
            if chosen.any():
                band = f"{low:g} to {high:g} N" if np.isfinite(high) else f"from {low:g} N"
                label = {"tips a face": int(tips), "force": band}
                rows.append(label | _row(matched, chosen, possible_mm))
    rest = matched.tips == 0
    if rest.any():
        rows.append({"tips a face": 0, "force": "rest"} | _row(matched, rest, possible_mm))
    return rows


def _row(
    matched: MatchedContacts, chosen: np.ndarray, possible_mm: np.ndarray | None
) -> dict[str, float | int | None]:
    pairs = chosen[matched.frame]
    distance, far = matched.distance_mm[pairs], matched.distance_mm[pairs] > FAR_MM
    paired = np.bincount(matched.frame[pairs], minlength=len(chosen))[chosen]
    missed = matched.true_number[chosen] - paired
    ghosts = matched.found_number[chosen] - paired
    frames = int(chosen.sum())
    pulled = {}
    if np.isfinite(matched.pull_error_n).any():
        error, size = matched.pull_error_n[pairs], matched.pull_n[pairs]
        pulled = {
            "tangential error N": _rounded(_mean(error), 3),
            "tangential force N": _rounded(_mean(size), 3),
        }
    return {
        "frames": frames,
        "number right %": _rounded(100 * matched.right[chosen].mean(), 1),
        "missed a frame": _rounded((missed.sum() + far.sum()) / frames, 3),
        "ghosts a frame": _rounded((ghosts.sum() + far.sum()) / frames, 3),
        "distance mm": _rounded(_mean(distance), 3),
        "95th percentile mm": _rounded(np.quantile(distance, 0.95) if len(distance) else np.nan, 3),
        "bound mm": None if possible_mm is None else _rounded(_mean(possible_mm[chosen]), 3),
        "total force N": _rounded(np.abs(matched.total_error_n[chosen]).mean(), 3),
        "each force N": _rounded(_mean(np.abs(matched.force_error_n[pairs])), 3),
        "place in 90 % region %": _rounded(100 * _mean(matched.place_covered[pairs]), 1),
        "force in 90 % interval %": _rounded(100 * _mean(matched.force_covered[pairs]), 1),
        "not explained %": _rounded(100 * _mean(~matched.explained[chosen]), 1),
        **pulled,
    }


def _mean(values: np.ndarray) -> float:
    values = values[np.isfinite(values)]
    return float(values.mean()) if len(values) else float("nan")


def _rounded(value: float, digits: int) -> float | None:
    return round(float(value), digits) if np.isfinite(value) else None


def possible_distance_mm(
    inversion: Inversion, frames: FrameSet, averaged: Int[np.ndarray, "frame"] | None = None
) -> Float[np.ndarray, "frame"]:
    """Mean distance between true and found places that the Cramér–Rao bound leaves an unbiased
    estimator that knows how many contacts there are, and nothing of where: mean over the contacts of
    each frame, NaN at rest.

    Of a planar normal error with standard deviations a ≥ b it is a √(2/π) E(1 − b²/a²), E the complete
    elliptic integral of the second kind.
    """
    from scipy.special import ellipe

    true_n = frames.force_n if frames.true_force_n is None else frames.true_force_n
    model = inversion.model
    index = {int(number): row for row, number in enumerate(model.signals.faces)}
    index[NO_FACE] = NONE
    face = np.vectorize(index.__getitem__, otypes=[int])(frames.contact_face)
    contact = np.concatenate([frames.contact_xy_mm, true_n[..., 2:]], axis=2)
    contact = np.where((face != NONE)[..., None], contact, 0.0)
    observed = inversion.disturbances.observed(all_counts(frames), averaged)
    curvature = curvature_at(model, observed, np.arange(len(frames)), face, contact)
    blocks = np.linalg.pinv(curvature, hermitian=True).reshape(
        len(frames), *face.shape[1:], 3, -1, 3
    )
    place_covariance = np.moveaxis(np.diagonal(blocks, axis1=1, axis2=3), -1, 1)[..., :2, :2]
    variance = np.maximum(np.linalg.eigvalsh(place_covariance), 1e-12)
    large, ratio = np.sqrt(variance[..., 1]), variance[..., 0] / variance[..., 1]
    distance = np.where(face != NONE, large * np.sqrt(2 / np.pi) * ellipe(1 - ratio), np.nan)
    has_contact = (face != NONE).any(axis=1)
    mean_mm = np.full(len(frames), np.nan)
    mean_mm[has_contact] = np.nanmean(distance[has_contact], axis=1)
    return mean_mm
